// What the runs of a study say: errors, observed orders, the frontier of error and time.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "cli/measurement.hpp"
#include "cli/study/fine_run.hpp"
#include "cli/study/timed_runs.hpp"
#include "io/study/study_reader.hpp"

namespace sandsim::cli {

/// One setting of a study, and what it gave.
struct StudyPoint {
  const StudyCase* setting = nullptr;
  const TimedResult* result = nullptr;
  std::optional<ErrorReport> against;                       // nothing if the run failed or its reference does not apply
  std::string note;                                         // why there is no error
  double error = std::numeric_limits<double>::quiet_NaN();  // by the study's measure
  std::optional<double> front_error;                        // [m] of the first front that the reference knows
  std::optional<double> height_error;                       // [m]
  double volume_error = 0.0;                                // [-]
  std::optional<double> seconds;  // [s] of the solver, as the study chooses it; nothing before the first timed run
  Measurement times;              // [s] over the repeats
  double cell_steps = 0.0;
  double bytes = 0.0;           // [B] moved by the solver
  std::optional<double> order;  // observed, from the next coarser spacing
  bool on_frontier = false;     // no other point of its scene is faster with an error at most 1 % larger
};

/// The points of one curve, from coarse to fine.
struct StudyCurve {
  std::size_t scene = 0;
  std::string label;  // what tells it from the other curves; empty if it is the only one
  std::vector<std::size_t> points;
};

struct StudyFindings {
  std::vector<StudyPoint> points;  // in the order of the plan
  std::vector<StudyCurve> curves;
};

/// `plan` and `results` (one a case) must outlive the findings; `fine` has one entry a scene, or none.
StudyFindings analyse(const StudyPlan& plan, const std::vector<TimedResult>& results,
                      const std::vector<FineDepth>& fine);

/// The quickest point of a scene with an error of at most `target`; null if there is none.
const StudyPoint* cheapest(const StudyFindings& findings, std::size_t scene, double target);

/// [s] and cell-steps at which a curve reaches an error, on the line through its points in logarithms.
struct CostToError {
  double seconds = 0.0;
  double cell_steps = 0.0;
};
/// Nothing if the curve never gets there.
std::optional<CostToError> cost_to_error(const StudyFindings& findings, const StudyCurve& curve, double target);

}  // namespace sandsim::cli
