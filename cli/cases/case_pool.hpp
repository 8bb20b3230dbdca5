// Many cases side by side on one machine.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "cli/cases/case_process.hpp"

namespace sandsim::cli {

/// One run of a scene.
struct CaseJob {
  std::string name;                    // for people
  std::filesystem::path scene;         // its file
  std::vector<std::string> overrides;  // "a.b=v", as --set takes them
  std::filesystem::path output;        // directory; results of an earlier run in it are replaced, or gone on with
  bool resume = false;                 // from output/checkpoint.h5, if there is one
  std::vector<std::string> options;    // more of `sandsim run`, such as --threads 1, --precision, --device, --max-wall
};

/// How a case ended. run.json in its directory tells the rest, if the run came as far as to write it.
struct CaseOutcome {
  bool started = false;       // false: the pool was interrupted before
  int exit_code = 0;          // of `sandsim run`; 128 + signal if a signal killed it
  std::string error_text;     // what it said on standard error
  double begin = 0.0;         // [s] after the pool's start
  double wall_seconds = 0.0;  // [s] from its start as a process to its end

  bool is_done() const { return started && exit_code == 0; }
};

/// A case that runs at the moment.
struct RunningCase {
  std::size_t index = 0;      // among the jobs
  double wall_seconds = 0.0;  // [s] since its start
  CaseProgress progress;
};

/// Calls that tell how the cases go on, all from the thread that called run_cases(). Empty ones are left out.
struct PoolObserver {
  std::function<void(std::size_t index)> started;
  std::function<void(std::size_t index, const CaseOutcome& outcome)> ended;
  std::function<void(std::span<const RunningCase> running)> tick;  // ten times a second
};

struct PoolSettings {
  int parallel = 1;                                     // processes at a time
  std::filesystem::path executable = "/proc/self/exe";  // the sandsim that runs the cases
  double max_wall = 0.0;                                // [s] ends the pool as a signal would; 0: no limit
  /// Asked before a case starts; true: it need not run any more, since another process has finished it.
  std::function<bool(std::size_t index)> is_finished_elsewhere;
};

struct PoolResult {
  std::vector<CaseOutcome> outcomes;  // one a job, in the order of the jobs
  bool interrupted = false;
  bool interrupted_by_limit = false;
  std::string signal;         // name of the signal that did so
  double wall_seconds = 0.0;  // [s]
};

/// True if the directory holds a run that was interrupted and left a checkpoint.
bool can_resume_case(const std::filesystem::path& directory);

/// Runs every job as `sandsim run ... -q`, `parallel` at a time, in the order given. A case that fails or crashes is an
/// outcome; the others go on. SIGINT, SIGTERM and SIGHUP start no more cases and reach the running ones, which write
/// their checkpoints; a second one kills. A job whose directory is locked by another process waits for it.
/// Throws only what the observer throws.
PoolResult run_cases(std::span<const CaseJob> jobs, const PoolSettings& settings, const PoolObserver& observer = {});

}  // namespace sandsim::cli
