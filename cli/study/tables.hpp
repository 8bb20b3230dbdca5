// The findings of a study as tables: Markdown for people, CSV for programs.
#pragma once

#include <string>
#include <vector>

#include "cli/study/ablation.hpp"
#include "cli/study/analysis.hpp"

namespace sandsim::cli {

/// Under what the times were taken.
struct StudySetting {
  std::string machine;  // processor, number of processors, vector instructions
  std::string date;
  double load_before = 0.0, load_after = 0.0;  // processes that wanted to run, mean of a minute
  int processors = 1;
  int repeats = 1;
  std::vector<std::string> remarks;  // what cannot be said, and why
};

/// table.md: a table a scene with errors, times and orders, the frontier, the cheapest settings, and the ablation.
std::string study_markdown(const StudyPlan& plan, const StudyFindings& findings,
                           const std::vector<AblationRow>& ablation, const StudySetting& setting);

/// study.csv: a row a setting, in SI units; empty cells for what is not known. Errors read back to the same bits.
std::string study_csv(const StudyPlan& plan, const StudyFindings& findings);

/// ablation.csv: a row a variant.
std::string ablation_csv(const std::vector<AblationRow>& rows);

}  // namespace sandsim::cli
