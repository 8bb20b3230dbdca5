// The directory that `sandsim stress` writes into.
#pragma once

#include <filesystem>
#include <vector>

#include "cli/stress/measure.hpp"
#include "cli/stress/stress_case.hpp"
#include "cli/stress/stress_table.hpp"

namespace sandsim::cli {

/// DIR/scenes holds the cases as scene files, DIR/failures those that failed with their scheme and precision set.
struct StressFiles {
  explicit StressFiles(const std::filesystem::path& directory);

  std::filesystem::path directory, scenes, failures, csv, maps, markdown;
};

/// Makes the directory. One that is not empty is refused unless `overwrite` is set, which removes what this command
/// writes and nothing else. Throws OutputError.
StressFiles prepare_stress_directory(const std::filesystem::path& directory, bool overwrite);

/// Writes a case's scene and rasters; the scene's file. Throws OutputError.
std::filesystem::path write_case(const StressCase& its, const std::filesystem::path& folder);

/// Writes the scene of a row that failed, ready for `sandsim run`, with what failed in its first lines.
void write_failure(const StressRow& row, const StressCase& its, const Trial& trial, const StressFiles& files);

}  // namespace sandsim::cli
