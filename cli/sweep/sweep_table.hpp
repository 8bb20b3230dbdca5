// The table of a sweep: cases by what was varied and what came of it.
#pragma once

#include <string>
#include <vector>

#include "cli/sweep/case_state.hpp"
#include "cli/sweep/sweep.hpp"
#include "io/output/table_file.hpp"

namespace sandsim::cli {

/// One row a case: number, status, the varied keys as numbers in their units (as texts where they are none), exit code,
/// runout, travel angles, area, volume out, stop time, errors, volume error, steps and wall time. What a case does not
/// have is NaN, and a column that no case has is left out.
Table sweep_table(const Sweep& sweep, const std::vector<CaseState>& states, const std::string& command_line);

}  // namespace sandsim::cli
