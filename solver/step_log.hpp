// The lengths of a run's steps: extremes over the run and since the last frame, and where the smallest one was.
#pragma once

#include <optional>

#include "solver/backend.hpp"
#include "solver/report.hpp"
#include "solver/simulation.hpp"

namespace sandsim {

/// Steps that were cut to land on a frame count over the run only as long as there is no other.
class StepLog {
 public:
  StepLog() = default;
  explicit StepLog(const Checkpoint& from);

  /// Before a step of length `dt` [s] from `time` [s]; `limited` by the stability of the backend's present state.
  void note(double dt, double time, bool limited, const Backend& backend);
  /// Forgets the steps since the last frame.
  void start_frame() { frame_min_ = frame_max_ = 0.0; }

  void save(Checkpoint& to) const;
  void report(RunReport& to) const;
  double frame_min() const { return frame_min_; }
  double frame_max() const { return frame_max_; }
  double max() const { return max_; }

 private:
  double min_ = 0.0, max_ = 0.0;              // [s] over the run
  double frame_min_ = 0.0, frame_max_ = 0.0;  // [s] since the last frame
  bool any_limited_ = false;
  std::optional<Incident> smallest_;
};

}  // namespace sandsim
