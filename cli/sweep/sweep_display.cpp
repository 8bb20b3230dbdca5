#include "cli/sweep/sweep_display.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <ostream>

#include "cli/text.hpp"

namespace sandsim::cli {

namespace {

struct TerminalSize {
  std::size_t columns = 80;
  std::size_t rows = 24;
};

TerminalSize terminal_size() {
  winsize size{};
  if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0 || size.ws_row == 0) {
    return {};
  }
  return {size.ws_col, size.ws_row};
}

std::string bar(double fraction) {
  constexpr double length = 12.0;
  return fmt::format("[{:-<12}]", std::string(static_cast<std::size_t>(std::lround(fraction * length)), '#'));
}

}  // namespace

std::string counts_line(const SweepCounts& counts, const char* rest) {
  std::string text = fmt::format("{} of {} done", counts.done, counts.total);
  const auto add = [&text](std::size_t number, const char* word) {
    if (number > 0) {
      text += fmt::format(", {} {}", number, word);
    }
  };
  add(counts.failed, "failed");
  add(counts.interrupted, "interrupted");
  add(counts.running, "running");
  add(counts.waiting(), rest);
  return text;
}

SweepDisplay::SweepDisplay(std::ostream& stream, Mode mode, const Sweep& sweep, SweepCounts counts)
    : stream_(stream), mode_(mode), sweep_(sweep), counts_(counts) {}

SweepDisplay::~SweepDisplay() {
  wipe();
}

void SweepDisplay::wipe() {
  if (drawn_ == 0) {
    return;
  }
  stream_ << fmt::format("\r\x1b[{}A\x1b[J", drawn_) << std::flush;
  drawn_ = 0;
}

void SweepDisplay::case_started() {
  ++counts_.running;
}

void SweepDisplay::case_ended(std::size_t index, const CaseState& state, double wall_seconds) {
  counts_.running -= std::min<std::size_t>(counts_.running, 1);
  ++ended_here_;
  switch (state.kind) {
    case CaseState::Kind::done:
      ++counts_.done;
      break;
    case CaseState::Kind::interrupted:
      ++counts_.interrupted;
      break;
    default:
      ++counts_.failed;
  }
  // A failure stays on the screen; what goes well is in the table's first line.
  const bool is_news = mode_ == Mode::lines || (mode_ == Mode::table && state.kind == CaseState::Kind::failed);
  if (!is_news) {
    return;
  }
  wipe();
  const std::string why = state.kind == CaseState::Kind::failed
                              ? fmt::format(" (exit code {}): {}", state.exit_code, state.message)
                              : " in " + format_duration(wall_seconds);
  stream_ << fmt::format("case {} of {}: {}{}  ({})\n", index + 1, counts_.total, state.status, why,
                         sweep_.description_of(sweep_.cases[index]))
          << std::flush;
}

std::string SweepDisplay::row(const RunningCase& one, std::size_t width) const {
  const CaseProgress& progress = one.progress;
  const double fraction = progress.end > 0.0 ? std::clamp(progress.time / progress.end, 0.0, 1.0) : 0.0;
  const std::string text =
      fmt::format("  case {:<5} {} {:3.0f} %  {:>6}  {}", one.index + 1, bar(fraction), std::floor(100.0 * fraction),
                  format_clock(one.wall_seconds), sweep_.description_of(sweep_.cases[one.index]));
  return text.substr(0, width);
}

void SweepDisplay::update(std::span<const RunningCase> running) {
  if (mode_ != Mode::table) {
    return;
  }
  const TerminalSize size = terminal_size();
  const std::size_t width = size.columns - 1;  // One column stays free, or some terminals wrap the line.
  const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  const double ended = static_cast<double>(ended_here_);
  const double left =
      ended > 0.0 ? elapsed / ended * static_cast<double>(counts_.waiting() + counts_.running) : INFINITY;
  std::string text =
      fmt::format("{}   {}  left {}", counts_line(counts_, "waiting"), format_clock(elapsed), format_clock(left))
          .substr(0, width);
  text += '\n';
  const std::size_t shown = std::min(running.size(), size.rows > 3 ? size.rows - 3 : 0);
  for (std::size_t k = 0; k < shown; ++k) {
    text += row(running[k], width) + '\n';
  }
  wipe();
  stream_ << text << std::flush;
  drawn_ = 1 + shown;
}

}  // namespace sandsim::cli
