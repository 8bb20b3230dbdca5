// One run from its prepared directory to its report.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/failures.hpp"
#include "cli/run_log.hpp"
#include "cli/signals.hpp"
#include "io/output/async_sink.hpp"
#include "io/output/output_directory.hpp"
#include "io/output/run_report.hpp"
#include "solver/simulation.hpp"

namespace sandsim::cli {

/// The scene and where its results go.
struct RunInput {
  Scene scene;
  std::string resolved;  // YAML
  std::string hash;
  std::vector<std::string> warnings;
  DeviceChoice device;
  std::filesystem::path directory;
};

/// The report of a run that an exception ended.
RunReport failed_report(const Failure& failure);

/// Runs the scene, writes everything into the directory, and prints what the user asked for. The directory is locked
/// by nothing: one session a directory.
class RunSession {
 public:
  /// All arguments must live longer than this. Opens the log and takes over the signals; throws OutputError.
  RunSession(const RunArguments& arguments, const RunInput& input, const OutputFiles& files, const RunContext& context,
             Console& console);

  /// Runs to the end, or from `checkpoint` if it is not null. run.json is written in any case. Throws what stopped the
  /// run, unless run() has put it into its report.
  ExitCode run(const Checkpoint* checkpoint);

 private:
  RunReport execute(const Checkpoint* checkpoint);
  void save(const Checkpoint& checkpoint, AsyncSink& sink);
  void log_progress(const Progress& progress);
  void log_start(const Checkpoint* checkpoint);
  void conclude(const RunReport& report);
  void write_xdmf_beside(bool finished);
  void print_end(const RunReport& report);
  void say(const std::string& message);

  const RunArguments& arguments_;
  const RunInput& input_;
  const OutputFiles& files_;
  const RunContext& context_;
  Console& console_;
  RunLog log_;
  SignalGuard signals_;
  bool checkpoint_written_ = false;
  bool stepped_ = false;
  std::chrono::steady_clock::time_point next_log_;
};

}  // namespace sandsim::cli
