// What the user sees while a sweep runs.
#pragma once

#include <chrono>
#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include "cli/cases/case_pool.hpp"
#include "cli/sweep/case_state.hpp"
#include "cli/sweep/sweep.hpp"

namespace sandsim::cli {

/// How many cases are where.
struct SweepCounts {
  std::size_t total = 0;
  std::size_t done = 0;
  std::size_t failed = 0;
  std::size_t interrupted = 0;
  std::size_t running = 0;

  std::size_t waiting() const { return total - done - failed - interrupted - running; }
};

/// "12 of 64 done, 1 failed, 2 running, 49 waiting"; `rest` is the word for the last of these.
std::string counts_line(const SweepCounts& counts, const char* rest);

/// On a terminal a table of the running cases that redraws itself; elsewhere a line for each case that has ended.
class SweepDisplay {
 public:
  enum class Mode { none, lines, table };

  /// `counts` are those of the cases that are done before it starts.
  SweepDisplay(std::ostream& stream, Mode mode, const Sweep& sweep, SweepCounts counts);
  ~SweepDisplay();
  SweepDisplay(const SweepDisplay&) = delete;
  SweepDisplay& operator=(const SweepDisplay&) = delete;

  void case_started();
  /// `index` counts the cases of the sweep.
  void case_ended(std::size_t index, const CaseState& state, double wall_seconds);
  /// The running cases, by their index among the cases of the sweep.
  void update(std::span<const RunningCase> running);

 private:
  void wipe();
  std::string row(const RunningCase& one, std::size_t width) const;

  std::ostream& stream_;
  Mode mode_;
  const Sweep& sweep_;
  SweepCounts counts_;
  std::size_t ended_here_ = 0;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::size_t drawn_ = 0;  // lines of the table on the terminal
};

}  // namespace sandsim::cli
