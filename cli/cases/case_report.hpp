// The numbers of a finished case that tables and plots are made of.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "io/output/read_run_report.hpp"

namespace sandsim::cli {

/// The deposit: the last frame that a case has kept. Its outline is where the depth, taken as linear between the
/// centres of cells, falls to `deposit_threshold`.
struct Deposit {
  double front = 0.0;   // [m] largest x of the outline
  double height = 0.0;  // [m] largest depth
  double runout = 0.0;  // [m] largest distance of the outline from the centre of mass of the first frame that has any
};

/// [-] of the largest depth in the first frame with sand and the last one: what is thinner is not part of the outline.
inline constexpr double deposit_threshold = 0.01;

struct CaseReport {
  RunReport run;
  std::string scene_hash;
  bool has_one_row = false;        // of cells: norms of errors are per width; known for cases that are done
  std::optional<Deposit> deposit;  // none where the series keeps no depth
};

/// Reads run.json and, for a case that is done, series.h5 in the directory. Nothing if there is no run.json, or a
/// broken one. Throws InputError if the series of a finished case cannot be read.
std::optional<CaseReport> read_case_report(const std::filesystem::path& directory);

}  // namespace sandsim::cli
