#include "cli/progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <ostream>

#include "cli/text.hpp"

namespace sandsim::cli {

namespace {

constexpr std::chrono::milliseconds redraw_interval{100};

int terminal_width() {
  winsize size{};
  const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : 80;
}

}  // namespace

std::string progress_line(const Progress& progress, double start, double elapsed, int width) {
  const double fraction = progress.end > 0.0 ? std::clamp(progress.time / progress.end, 0.0, 1.0) : 0.0;
  const double simulated = progress.time - start;
  const double left = simulated > 0.0 ? elapsed * (progress.end - progress.time) / simulated : INFINITY;
  const std::string head = fmt::format("{:3.0f} % ", std::floor(100.0 * fraction));
  const std::string tail = fmt::format(" {:.4g} of {:.4g} s  left {}  {}", progress.time, progress.end,
                                       format_clock(left), format_rate(progress.cell_steps_per_second));
  // The bar takes what the numbers leave, up to 30 characters; on a narrow terminal it goes first.
  const int room = std::min(width - static_cast<int>(head.size() + tail.size()) - 2, 30);
  std::string bar;
  if (room >= 5) {
    const auto full = static_cast<std::size_t>(std::lround(fraction * room));
    bar = fmt::format("[{:-<{}}]", std::string(full, '#'), room);
  }
  return (head + bar + tail).substr(0, static_cast<std::size_t>(std::max(width, 0)));
}

ProgressBar::ProgressBar(std::ostream& stream, bool enabled) : stream_(stream), enabled_(enabled) {}

ProgressBar::~ProgressBar() {
  if (drawn_) {
    stream_ << "\r\x1b[K" << std::flush;
  }
}

void ProgressBar::update(const Progress& progress) {
  if (!enabled_) {
    return;
  }
  const Clock::time_point now = Clock::now();
  if (!started_) {
    started_ = true;
    start_ = progress.time;
    begin_ = now;
    next_ = now + redraw_interval;  // Runs that end sooner than this draw nothing.
  }
  if (now < next_) {
    return;
  }
  next_ = now + redraw_interval;
  drawn_ = true;
  const double elapsed = std::chrono::duration<double>(now - begin_).count();
  // One column stays free, or some terminals wrap the line.
  stream_ << '\r' << progress_line(progress, start_, elapsed, terminal_width() - 1) << "\x1b[K" << std::flush;
}

void ProgressFeed::update(const Progress& progress) {
  const auto now = std::chrono::steady_clock::now();
  if (descriptor_ < 0 || now < next_) {
    return;
  }
  next_ = now + redraw_interval;
  // Always of the same length, so that a shorter line leaves nothing of the one before.
  const std::string line = fmt::format("{:<20.9g} {:<20.9g}\n", progress.time, progress.end);
  if (pwrite(descriptor_, line.data(), line.size(), 0) < 0) {
    descriptor_ = -1;  // Whoever asked for it is gone, or it is no file: the run does not depend on it.
  }
}

}  // namespace sandsim::cli
