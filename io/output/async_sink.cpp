#include "io/output/async_sink.hpp"

#include <utility>

namespace sandsim {

AsyncSink::AsyncSink(Sink& inner, ErrorHandler on_lost_error, std::size_t capacity)
    : inner_(inner), on_lost_error_(std::move(on_lost_error)), capacity_(capacity == 0 ? 1 : capacity) {
  thread_ = std::thread([this] { work(); });
}

AsyncSink::~AsyncSink() {
  stop();
  if (!error_ || error_seen_ || !on_lost_error_) return;
  try {
    std::rethrow_exception(error_);
  } catch (const std::exception& error) {
    on_lost_error_(error.what());
  } catch (...) {
    on_lost_error_("unknown error while writing");
  }
}

void AsyncSink::begin(const Scene& scene, const StaticFields& fields) {
  drain();
  inner_.begin(scene, fields);
}

void AsyncSink::frame(Frame frame) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return error_ || waiting_.size() < capacity_; });
  rethrow_error();
  waiting_.push_back(std::move(frame));
  changed_.notify_all();
}

void AsyncSink::end(const FinalFields& fields) {
  drain();
  inner_.end(fields);
}

void AsyncSink::drain() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return error_ || (waiting_.empty() && !writing_); });
  rethrow_error();
}

void AsyncSink::rethrow_error() {
  if (!error_) return;
  error_seen_ = true;
  std::rethrow_exception(error_);
}

void AsyncSink::stop() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
    changed_.notify_all();
  }
  thread_.join();
}

void AsyncSink::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return stopping_ || !waiting_.empty(); });
    if (waiting_.empty()) return;
    Frame frame = std::move(waiting_.front());
    waiting_.pop_front();
    writing_ = true;
    changed_.notify_all();
    lock.unlock();
    std::exception_ptr error;
    try {
      inner_.frame(std::move(frame));
    } catch (...) {
      error = std::current_exception();
    }
    lock.lock();
    writing_ = false;
    if (error) {
      error_ = error;
      waiting_.clear();
    }
    changed_.notify_all();
  }
}

}  // namespace sandsim
