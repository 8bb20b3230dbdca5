#include "cli/signals.hpp"

namespace sandsim::cli {

namespace {

constexpr std::array<int, 3> ending_signals{SIGINT, SIGTERM, SIGHUP};

// A signal handler has no arguments of its own: these two are all that it may touch, and both are lock-free.
std::atomic<bool> interrupt_flag{false};
std::atomic<int> last_signal{0};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

extern "C" void sandsim_on_signal(int signal_number) {
  last_signal = signal_number;
  interrupt_flag = true;
  struct sigaction standard {};
  standard.sa_handler = SIG_DFL;
  for (const int ending : ending_signals) {
    sigaction(ending, &standard, nullptr);
  }
}

}  // namespace

SignalGuard::SignalGuard() {
  interrupt_flag = false;
  last_signal = 0;
  struct sigaction ours {};
  ours.sa_handler = sandsim_on_signal;
  ours.sa_flags = SA_RESTART;  // Writes that are under way are not cut short.
  for (std::size_t k = 0; k < ending_signals.size(); ++k) {
    sigaction(ending_signals[k], nullptr, &previous_[k]);
    if (previous_[k].sa_handler != SIG_IGN) {
      sigaction(ending_signals[k], &ours, nullptr);
    }
  }
  struct sigaction ignore {};
  ignore.sa_handler = SIG_IGN;
  sigaction(SIGXFSZ, &ignore, &previous_.back());
}

SignalGuard::~SignalGuard() {
  for (std::size_t k = 0; k < ending_signals.size(); ++k) {
    sigaction(ending_signals[k], &previous_[k], nullptr);
  }
  sigaction(SIGXFSZ, &previous_.back(), nullptr);
}

const std::atomic<bool>& SignalGuard::interrupted() const {
  return interrupt_flag;
}

const char* SignalGuard::name() const {
  switch (last_signal.load()) {
    case SIGINT:
      return "SIGINT";
    case SIGTERM:
      return "SIGTERM";
    case SIGHUP:
      return "SIGHUP";
    default:
      return "";
  }
}

}  // namespace sandsim::cli
