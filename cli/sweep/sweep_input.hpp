// From the command line to a sweep and its folder.
#pragma once

#include <optional>

#include "cli/options.hpp"
#include "cli/sweep/sweep_folder.hpp"

namespace sandsim::cli {

/// A sweep that is ready to be worked on.
struct OpenSweep {
  Sweep sweep;
  SweepFiles files;
  bool is_read_back = false;     // from sweep.json: its scene and files may have changed since
  std::optional<FileLock> lock;  // none for actions that share the sweep with others: --case, --collect, --list
};

/// Number of cases above which --yes is needed.
inline constexpr std::uint64_t many_cases = 1000;
/// Number of cases above which nothing helps.
inline constexpr std::uint64_t too_many_cases = 1'000'000;

/// The sweep that the arguments describe, or that lies in the directory that they name, its folder made ready.
/// Throws Error with exit code 1 (usage), 2 (invalid cases), 3 (files) or 6 (folder).
OpenSweep open_sweep(const SweepArguments& arguments);

/// Throws InputError unless the case comes to the same scene and files as when the sweep was made.
void require_unchanged(const Sweep& sweep, std::size_t index);

}  // namespace sandsim::cli
