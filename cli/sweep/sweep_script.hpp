// A sweep as an array of Slurm's jobs.
#pragma once

#include <filesystem>
#include <string>

#include "cli/sweep/sweep_folder.hpp"

namespace sandsim::cli {

/// A script for sbatch that runs case number $SLURM_ARRAY_TASK_ID of the sweep with `executable`.
std::string sweep_script(const SweepFiles& files, std::size_t cases, const std::filesystem::path& executable);

}  // namespace sandsim::cli
