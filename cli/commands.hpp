// The subcommands of sandsim. Each prints its results to the console and returns the exit code, or throws an Error.
#pragma once

#include <iosfwd>

#include "cli/options.hpp"
#include "solver/report.hpp"

namespace sandsim::cli {

/// Where a command prints.
struct Console {
  std::ostream& out;      // results
  std::ostream& err;      // progress, warnings, errors
  bool terminal = false;  // whether `err` is a terminal, so that a progress bar makes sense
};

ExitCode run_command(const RunArguments& arguments, Console& console);
ExitCode sweep_command(const SweepArguments& arguments, Console& console);
ExitCode fit_command(const FitArguments& arguments, Console& console);
ExitCode check_command(const CheckArguments& arguments, Console& console);
ExitCode info_command(const InfoArguments& arguments, Console& console);
ExitCode export_command(const ExportArguments& arguments, Console& console);
ExitCode schema_command(const SchemaArguments& arguments, Console& console);
ExitCode devices_command(Console& console);
ExitCode bench_command(const BenchArguments& arguments, Console& console);
ExitCode study_command(const StudyArguments& arguments, Console& console);
ExitCode stress_command(const StressArguments& arguments, Console& console);

}  // namespace sandsim::cli
