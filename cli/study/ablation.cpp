#include "cli/study/ablation.hpp"

#include <algorithm>

#include "cli/text.hpp"

namespace sandsim::cli {

namespace {

/// Value by value over the rounds that both have.
Measurement ratios(const std::vector<double>& values, const std::vector<double>& base) {
  std::vector<double> quotients;
  for (std::size_t k = 0; k < std::min(values.size(), base.size()); ++k) {
    quotients.push_back(values[k] / base[k]);
  }
  return summarise(std::move(quotients));
}

double cell_steps(const RunReport& report) {
  return static_cast<double>(report.cells) * static_cast<double>(report.steps);
}

/// [ns] a cell and step, one value a round.
std::vector<double> step_costs(const TimedResult& result) {
  std::vector<double> costs;
  for (const double seconds : result.solving) {
    costs.push_back(1e9 * seconds / std::max(cell_steps(result.report), 1.0));
  }
  return costs;
}

}  // namespace

std::vector<AblationRow> compare_variants(const StudyPlan& plan, const std::vector<TimedResult>& results) {
  std::vector<AblationRow> rows;
  if (results.empty() || results.front().wall.empty()) {
    return rows;
  }
  const TimedResult& base = results.front();
  for (std::size_t k = 0; k < results.size(); ++k) {
    const TimedResult& result = results[k];
    if (result.wall.empty()) {
      continue;
    }
    AblationRow row;
    row.name = plan.variants[k].name;
    row.report = &result.report;
    row.wall = summarise(result.wall);
    row.wall_ratio = ratios(result.wall, base.wall);
    row.nanoseconds = summarise(step_costs(result));
    row.ratio = ratios(step_costs(result), step_costs(base));
    std::vector<std::string> stages;
    for (const StageReport& stage : result.report.stages) {
      row.bytes_per_cell_step += stage.name == "frames" ? 0.0 : stage.bytes / std::max(cell_steps(result.report), 1.0);
      stages.push_back(stage.name);
    }
    row.stages = join(", ", stages);
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace sandsim::cli
