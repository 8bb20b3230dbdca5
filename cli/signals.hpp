// Ctrl-C and friends: the first ends the run after its current step, the second ends the process.
#pragma once

#include <signal.h>

#include <array>
#include <atomic>

namespace sandsim::cli {

/// While it lives, the first SIGINT, SIGTERM or SIGHUP sets interrupted() and restores the default action of all
/// three, so that the next one kills at once. Signals that were ignored before (nohup, background jobs) stay ignored.
/// SIGXFSZ is ignored: a write beyond the file size limit then fails and is reported, instead of killing the process.
/// One at a time.
class SignalGuard {
 public:
  SignalGuard();
  ~SignalGuard();
  SignalGuard(const SignalGuard&) = delete;
  SignalGuard& operator=(const SignalGuard&) = delete;

  const std::atomic<bool>& interrupted() const;
  /// Name of the signal that came, for messages; "" if none did.
  const char* name() const;

 private:
  std::array<struct sigaction, 4> previous_{};
};

}  // namespace sandsim::cli
