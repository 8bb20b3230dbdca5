// The numbers of a finished case that tables and plots are made of.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "io/output/read_run_report.hpp"

namespace sandsim::cli {

struct CaseReport {
  RunReport run;
  std::string scene_hash;
  bool has_one_row = false;  // of cells: norms of errors are per width; known for cases that are done
};

/// Reads run.json and, for a case that is done, series.h5 in the directory. Nothing if there is no run.json, or a
/// broken one. Throws InputError if the series of a finished case cannot be read.
std::optional<CaseReport> read_case_report(const std::filesystem::path& directory);

}  // namespace sandsim::cli
