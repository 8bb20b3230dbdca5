// The report of a run: what happened, whatever the end. Written also on failure; the exit code comes from it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "solver/runout_report.hpp"

namespace sandsim {

/// Process exit codes.
enum class ExitCode : int {
  done = 0,
  usage = 1,
  invalid_scene = 2,
  missing_input = 3,
  device = 4,
  numerical_failure = 5,
  output = 6,
  wall_clock_limit = 7,
  interrupted = 130,
};

/// What one stage of the step cost. Only stages that the scene has are listed.
struct StageReport {
  std::string name;
  double seconds = 0.0;
  std::int64_t launches = 0;  // calls of the stage
  double bytes = 0.0;         // bytes moved to and from memory by the stage's arrays, summed over calls
};

/// What a kinematic object did to the sand, summed over the run; per density. Sand that an object displaces counts each
/// time that it meets it: also its own berm, and what runs in under it as it rises and is pushed back.
struct ObjectReport {
  std::string name;
  double overlapped_volume = 0.0;            // [m^3] of sand that it met in the last step, before it was moved
  double displaced_volume = 0.0;             // [m^3] moved out of its way, summed over the steps
  std::array<double, 2> momentum{0.0, 0.0};  // [m^4/s] given to the sand
  double work = 0.0;                         // [m^5/s^2] likewise
  double deepest = 0.0;  // [m] largest depth under the highest sand beside it; drag: under sand on it
  double seconds = 0.0;  // spent on it
};

/// What became of the particles. A cell of their grid that others leave empty gets a new one: born = merged + left.
struct ParticleReport {
  std::int64_t count = 0;   // at any time
  std::int64_t moves = 0;   // of all of them
  std::int64_t born = 0;    // after the first
  std::int64_t merged = 0;  // gone: an older one was in the same cell, and none beside it was empty
  std::int64_t left = 0;    // through open sides
};

/// Volume that entered and left, summed over the run. [m^3]
struct Ledger {
  double initial = 0.0;
  double final = 0.0;
  double in = 0.0;
  double out = 0.0;
  double clipped = 0.0;  // volume made or lost by clipping negative depths
  /// (final - initial - in + out) / max(initial + in, tiny): relative drift. [-]
  double error() const;
};

/// Where the initial sand of the scene is: file = grid + outside + blocked. Sand that is filled up to a level counts on
/// the grid only: elsewhere there is no ground that would tell how much it is. [m^3]
struct ReleaseReport {
  double file_volume = 0.0;     // of the shapes and files of the scene
  double grid_volume = 0.0;     // that the run starts with
  double outside_volume = 0.0;  // outside the grid
  double blocked_volume = 0.0;  // where solid objects stand, or the terrain is a wall for lack of data
};

/// A cell and a moment, and why they are worth a word.
struct Incident {
  int i = -1;
  int j = -1;
  double time = 0.0;  // [s]
  double step = 0.0;  // [s] length of the step, where that matters
  std::string cause;
};

/// Error against one reference at the end of the run. Norms of the depth; relative norms are divided by the
/// reference's norm.
struct ErrorReport {
  std::string against;
  double time = 0.0;                   // [s] at which it was taken
  std::optional<double> l1, l2, linf;  // 1-D, per width: [m^2], [m^1.5], [m]; 2-D: [m^3], [m^2], [m]
  std::optional<double> l1_relative;   // [-]
  struct Front {
    double depth = 0.0;               // [m] threshold; 0: the tip
    double computed = 0.0;            // [m]
    std::optional<double> reference;  // [m]
  };
  std::vector<Front> fronts;
  struct Height {
    double computed = 0.0;   // [m] deepest sand, where the reference is known
    double reference = 0.0;  // [m] likewise
  };
  std::optional<Height> height;
  std::string note;  // e.g. that the measured file is missing
};

struct RunReport {
  std::string status = "not started";  // "done", "at rest", "failed", "interrupted", "wall-clock limit"
  ExitCode exit_code = ExitCode::done;
  std::string message;

  std::string device;  // e.g. "cpu"
  int threads = 1;     // that most steps took
  std::string precision;
  std::string scheme;
  int order = 0;
  std::int64_t cells = 0;
  std::int64_t steps = 0;
  std::int64_t frames = 0;             // frames handed to the sinks
  double simulated_time = 0.0;         // [s]
  double wall_time = 0.0;              // [s] whole run, output included
  double first_step_time = 0.0;        // [s] wall clock from the start of the run to the first step
  double cell_steps_per_second = 0.0;  // cells * steps / seconds spent in the solver's stages
  std::vector<StageReport> stages;
  std::vector<ObjectReport> objects;  // those that are coupled in every step
  std::optional<ParticleReport> particles;
  std::int64_t memory_bytes = 0;  // allocated by the backend
  Ledger ledger;
  ReleaseReport release;
  double dt_min = 0.0;  // [s]
  double dt_max = 0.0;  // [s]
  std::optional<Incident> smallest_step;
  std::optional<Incident> failure;
  bool at_rest = false;
  double stop_time = 0.0;              // [s] first moment from which nothing moved; 0 if it never stopped
  double max_slope_violation = 0.0;    // [-] at the end: largest |ds|/(mu dx) - 1 over wet faces, 0 if none
  std::optional<RunoutReport> runout;  // none if the run failed
  std::vector<ErrorReport> errors;
};

}  // namespace sandsim
