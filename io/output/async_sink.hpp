// Runs another sink beside the solver, on a thread of its own.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

#include "solver/sink.hpp"

namespace sandsim {

/// Hands frames to `inner` from a second thread. At most `capacity` frames wait; then frame() waits as well. begin()
/// and end() call `inner` in the caller's thread, while the second thread is not at work. An exception of `inner` is
/// rethrown by the next call and by every later one; frames that were still waiting are then dropped.
/// Destroyed without end(), it first writes what waits. An error that no call has thrown yet then goes to
/// `on_lost_error`.
class AsyncSink : public Sink {
 public:
  using ErrorHandler = std::function<void(const std::string&)>;

  /// `inner` must live longer than this.
  explicit AsyncSink(Sink& inner, ErrorHandler on_lost_error = {}, std::size_t capacity = 2);
  ~AsyncSink() override;
  AsyncSink(const AsyncSink&) = delete;
  AsyncSink& operator=(const AsyncSink&) = delete;

  void begin(const Scene& scene, const StaticFields& fields) override;
  void frame(Frame frame) override;
  void end(const FinalFields& fields) override;

  /// Waits until every frame has been written. Throws what the other thread threw.
  void drain();

 private:
  void work();
  void rethrow_error();
  void stop();

  Sink& inner_;
  ErrorHandler on_lost_error_;
  std::size_t capacity_;
  std::mutex mutex_;  // guards all members below but the thread
  std::condition_variable changed_;
  std::deque<Frame> waiting_;
  bool writing_ = false;
  bool stopping_ = false;
  bool error_seen_ = false;
  std::exception_ptr error_;
  std::thread thread_;
};

}  // namespace sandsim
