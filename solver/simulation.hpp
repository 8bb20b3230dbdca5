// A run of a scene: steps from frame to frame, hands frames to a sink, and reports.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "solver/device.hpp"
#include "solver/particles.hpp"
#include "solver/report.hpp"
#include "solver/runout.hpp"
#include "solver/scene.hpp"
#include "solver/sink.hpp"

namespace sandsim {

/// All that is needed to go on with a run bit for bit. The arrays are ny * nx, x fastest, in the run's precision.
struct Checkpoint {
  std::int64_t steps = 0;
  std::int64_t frames = 0;      // frames already handed to the sink
  double time = 0.0;            // [s]
  double frame_step_min = 0.0;  // [s] since the last frame
  double frame_step_max = 0.0;  // [s]
  double wall_time = 0.0;       // [s] spent before
  Ledger ledger;
  double dt_min = 0.0, dt_max = 0.0;  // [s] over the run
  Incident smallest_step;
  double stop_time = 0.0;  // [s]
  StateArrays state;
  ParticleArrays particles;                        // empty without scene.particles
  FieldValues max_depth, max_speed, arrival_time;  // empty unless output.maxima
  RunoutRecord runout;                             // empty with output.maxima
};

/// What a progress display may want to know; called from the solver's thread between steps.
struct Progress {
  double time = 0.0;  // [s] simulated
  double end = 0.0;   // [s]
  double step = 0.0;  // [s]
  std::int64_t steps = 0;
  double cell_steps_per_second = 0.0;
};

struct RunOptions {
  Device device = Device::cpu;                        // cpu or cuda: choose_device() settles `automatic`
  int threads = 0;                                    // 0: as many as are free and pay
  const std::atomic<bool>* interrupt = nullptr;       // set by a signal handler: end after the current step
  double max_wall = 0.0;                              // [s] 0: no limit
  std::function<void(const Progress&)> progress;      // may be empty
  std::function<void(const std::string&)> warn;       // of the initial state, before the first step; may be empty
  std::function<void(const Checkpoint&)> checkpoint;  // called on interrupt, limit and at checkpoint_interval
  const Checkpoint* resume = nullptr;                 // go on from here
};

/// Runs a checked scene to its end. Numerical failures, interrupts and limits do not throw: they are in the report
/// (failure: cell, time, cause), and the last good frame has been handed to the sink.
/// Throws OutputError from the sink (the report is then lost: the caller reports the error), DeviceError.
RunReport run(const Scene& scene, const RunOptions& options, Sink& sink);

/// What a run of the scene would begin with, without running it.
struct Plan {
  double first_step = 0.0;           // [s] stable step of the initial state; infinite if nothing moves
  std::int64_t predicted_steps = 0;  // end / first_step (or the fixed step): an estimate
  ReleaseReport release;
  std::vector<std::string> warnings;  // of the initial state
  // [m] bed of the cells in the corners of the grid: south-west, south-east, north-west, north-east
  std::array<double, 4> corner_beds{};
};
Plan plan(const Scene& scene);

/// The stages that a run of the scene has, in the order of the report.
std::vector<std::string> stage_names(const Scene& scene);

}  // namespace sandsim
