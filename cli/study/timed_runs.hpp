// Runs that are timed: one after the other, in rounds, so that a load that comes and goes meets all of them.
#pragma once

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <vector>

#include "solver/device.hpp"
#include "solver/report.hpp"
#include "solver/scene.hpp"

namespace sandsim::cli {

/// What is run. The scene must outlive the runs.
struct TimedJob {
  const Scene* scene = nullptr;
  Device device = Device::cpu;  // cpu or cuda
  int threads = 1;
  bool writes = false;  // its frames go to a series.h5, as those of `sandsim run`
};

/// What came out. Times have one value a timed repeat.
struct TimedResult {
  RunReport report;             // of the first run, which only warms up
  std::vector<double> depth;    // [m] at its end
  std::vector<double> solving;  // [s] in the solver's stages, frames excepted
  std::vector<double> wall;     // [s] from the scene in memory to the report, output included
  bool failed() const { return report.failure.has_value(); }
};

/// [s] A warm-up that took so long is a measurement: start-up costs are nothing against it.
inline constexpr double long_run = 2.0;

struct RoundOptions {
  int repeats = 1;
  std::filesystem::path scratch;  // folder of the files of jobs that write; they are removed
  const std::atomic<bool>* interrupt = nullptr;
  std::function<void(int round, std::size_t job)> progress;  // before each run; round 0 warms up; may be empty
};

/// Runs every job once to warm up, then `repeats` rounds of all, every other round backwards. Jobs that fail are not
/// repeated. Ends early, with what there is, when interrupted. Throws DeviceError and OutputError.
/// `after_round` is given what there is after each round; it may be empty.
std::vector<TimedResult> run_rounds(const std::vector<TimedJob>& jobs, const RoundOptions& options,
                                    const std::function<void(const std::vector<TimedResult>&)>& after_round = {});

/// Runs a scene once: its report, and the depth [m] at the end, which its output must hold.
TimedResult run_once(const TimedJob& job, const RoundOptions& options);

}  // namespace sandsim::cli
