// run.json read back.
#pragma once

#include <filesystem>
#include <string>

#include "solver/report.hpp"

namespace sandsim {

/// What run_report_json() has written, as far as later commands ask for it.
struct StoredRun {
  RunReport report;
  std::string scene_hash;
  std::string started;  // wall clock, ISO 8601
};

/// Numbers that were not finite are NaN. Objects, the smallest step and the failing cell are left out.
/// Throws InputError if the file is missing or is no run report.
StoredRun read_run_report(const std::filesystem::path& path);

}  // namespace sandsim
