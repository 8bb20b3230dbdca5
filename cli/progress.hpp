// The progress bar on a terminal.
#pragma once

#include <chrono>
#include <iosfwd>
#include <string>

#include "solver/simulation.hpp"

namespace sandsim::cli {

/// One line: percent done, a bar, simulated time, time left and speed; at most `width` characters.
/// `start` is the simulated time at which this process began, `elapsed` its wall time. [s]
std::string progress_line(const Progress& progress, double start, double elapsed, int width);

/// Draws progress_line() over itself, at most ten times a second, and wipes it when it goes.
class ProgressBar {
 public:
  /// Draws nothing unless `enabled`.
  ProgressBar(std::ostream& stream, bool enabled);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void update(const Progress& progress);

 private:
  using Clock = std::chrono::steady_clock;

  std::ostream& stream_;
  bool enabled_;
  bool drawn_ = false;
  bool started_ = false;
  double start_ = 0.0;       // [s] simulated time at the first update
  Clock::time_point begin_;  // first update
  Clock::time_point next_;   // earliest moment of the next drawing
};

/// Tells the process that started this one how far the run is: "TIME END\n" [s] at the start of the file that
/// `descriptor` names, at most ten times a second. Not a pipe: nobody has to read it.
class ProgressFeed {
 public:
  /// Writes nothing if the descriptor is negative.
  explicit ProgressFeed(int descriptor) : descriptor_(descriptor) {}

  void update(const Progress& progress);

 private:
  int descriptor_;
  std::chrono::steady_clock::time_point next_{};
};

}  // namespace sandsim::cli
