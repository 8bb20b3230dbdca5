// What the features of a scene cost: variants against their base.
#pragma once

#include <string>
#include <vector>

#include "cli/measurement.hpp"
#include "cli/study/timed_runs.hpp"
#include "io/study/study_reader.hpp"

namespace sandsim::cli {

/// One variant. Ratios are to the base's run of the same round, of which a long warm-up may be the first.
struct AblationRow {
  std::string name;
  const RunReport* report = nullptr;
  Measurement wall;                  // [s] of the whole run, output included
  Measurement wall_ratio;            // [-]
  Measurement nanoseconds;           // [ns] of the solver a cell and step
  Measurement ratio;                 // [-] of these
  double bytes_per_cell_step = 0.0;  // [B] moved by the solver
  std::string stages;                // "step, maxima"
};

/// One row a variant, the base first; nothing for those that were not timed, or if the base was not. `plan` and
/// `results` (one a variant) must outlive the rows.
std::vector<AblationRow> compare_variants(const StudyPlan& plan, const std::vector<TimedResult>& results);

}  // namespace sandsim::cli
