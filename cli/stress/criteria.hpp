// What was measured in the runs of a case, and whether that is as it has to be.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cli/stress/stress_case.hpp"
#include "solver/scene.hpp"

namespace sandsim::cli {

/// A run of a scene and its repetition, as plain numbers.
struct Measurement {
  int exit_code = 0;
  std::string message;           // of a run that did not come to its end
  bool is_finite = true;         // depth and momentum in all frames
  bool is_positive = true;       // depth in all frames
  bool is_repeated = true;       // the second run has the bits of the first
  bool is_unchanged = false;     // the last frame has the values of the first
  bool at_rest = false;          // at the end
  double slope_violation = 0.0;  // [-] largest |ds|/(mu dx) - 1 over wet faces at the end
  std::int64_t steps = 0;
  double volume_error = 0.0;  // relative
  double max_speed = 0.0;     // [m/s] in all steps
  double dt_min = 0.0;        // [s]
  double energy_speed = 0.0;  // [m/s] E, see Criteria
  double spacing = 0.0;       // [m]
  double wall_time = 0.0;     // [s] of the first run

  /// The largest speed in E; 0 if neither moves, infinite if only the sand does.
  double relative_speed() const;
  /// The shortest step in dx/E.
  double relative_step() const;

  /// As one string, and back: it has to pass from process to process.
  std::string encode() const;
  static Measurement decode(const std::string& text);
};

/// A criterion that a run does not satisfy.
struct Finding {
  std::string criterion;  // ending, finite, depth, volume, speed, step, rest, stops, repeat
  std::string what;       // the numbers
};

/// All criteria that the runs do not satisfy; empty: they passed. A run that has to be refused is judged by its end,
/// its values and its repetition only.
std::vector<Finding> judge(const Measurement& measured, const Criteria& criteria, Precision precision);

}  // namespace sandsim::cli
