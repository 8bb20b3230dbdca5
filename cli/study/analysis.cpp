#include "cli/study/analysis.hpp"

#include <algorithm>
#include <cmath>

#include "cli/text.hpp"
#include "io/study/study_parameters.hpp"
#include "solver/reference/compare.hpp"

namespace sandsim::cli {

namespace {

/// Whether a report of the solver is one against this reference.
bool is_against(const ErrorReport& report, Against against) {
  switch (against) {
    case Against::profile:
      return report.against.starts_with("profile ");
    case Against::measured_profile:
      return report.against.starts_with("measured profile ");
    case Against::measured_front:
      return report.against.starts_with("measured front ");
    case Against::fine:
      return report.against == "fine run";
    case Against::exact:
      break;
  }
  return !report.against.starts_with("profile ") && !report.against.starts_with("measured ");
}

std::optional<double> front_error(const ErrorReport& report) {
  for (const ErrorReport::Front& front : report.fronts) {
    if (front.reference && std::isfinite(front.computed)) {
      return std::abs(front.computed - *front.reference);
    }
  }
  return std::nullopt;
}

double measured(const StudyPoint& point, ErrorMeasure measure) {
  const ErrorReport& report = *point.against;
  const auto or_nan = [](const std::optional<double>& value) {
    return value.value_or(std::numeric_limits<double>::quiet_NaN());
  };
  switch (measure) {
    case ErrorMeasure::l1:
      return or_nan(report.l1);
    case ErrorMeasure::l2:
      return or_nan(report.l2);
    case ErrorMeasure::linf:
      return or_nan(report.linf);
    case ErrorMeasure::front:
      return or_nan(point.front_error);
    case ErrorMeasure::height:
      return or_nan(point.height_error);
    case ErrorMeasure::volume:
      return point.volume_error;
    case ErrorMeasure::l1_relative:
      break;
  }
  return or_nan(report.l1_relative);
}

/// The point with the first of the reports that gives the chosen error; else why none does.
void choose_report(StudyPoint& point, const std::vector<ErrorReport>& reports, const ErrorChoice& choice) {
  for (const ErrorReport& report : reports) {
    if (choice.against && !is_against(report, *choice.against)) {
      continue;
    }
    point.against = report;
    point.front_error = front_error(report);
    point.height_error.reset();
    if (report.height) {
      point.height_error = std::abs(report.height->computed - report.height->reference);
    }
    point.error = measured(point, choice.measure);
    if (std::isfinite(point.error)) {
      point.note.clear();
      return;
    }
    point.note += (point.note.empty() ? "" : "; ") + report.against;
    point.note += report.note.empty() ? std::string(": has no ") + enum_name(choice.measure) : ": " + report.note;
  }
  point.against.reset();
}

std::vector<ErrorReport> reports_of(const StudyPlan& plan, const StudyCase& setting, const TimedResult& result,
                                    const std::vector<FineDepth>& fine) {
  if (!plan.study.fine) {
    return result.report.errors;
  }
  const Scene& scene = setting.setup;
  const std::vector<double> fronts = scene.reference ? scene.reference->front_depths : std::vector<double>{};
  return {compare_fine(scene.grid, result.depth, plan.fine[setting.scene].setup.grid, fine[setting.scene].depth,
                       result.report.simulated_time, fronts)};
}

StudyPoint point_of(const StudyPlan& plan, const StudyCase& setting, const TimedResult& result,
                    const std::vector<FineDepth>& fine) {
  StudyPoint point;
  point.setting = &setting;
  point.result = &result;
  const RunReport& report = result.report;
  if (report.status == "not started" || report.exit_code != ExitCode::done) {
    point.note = report.message.empty() ? report.status : report.message;
    return point;
  }
  point.volume_error = std::abs(report.ledger.error());
  point.cell_steps = static_cast<double>(report.cells) * static_cast<double>(report.steps);
  for (const StageReport& stage : report.stages) {
    point.bytes += stage.name == "frames" ? 0.0 : stage.bytes;
  }
  if (!result.solving.empty()) {
    point.times = summarise(result.solving);
    point.seconds = plan.study.times == TimeChoice::shortest ? point.times.least : point.times.median;
  }
  choose_report(point, reports_of(plan, setting, result, fine), plan.study.error);
  return point;
}

/// What tells a curve from the others of its scene.
std::string label_of(const Study& study, const StudyCase& setting) {
  std::vector<std::string> parts;
  if (!setting.method.empty()) {
    parts.push_back(setting.method);
  }
  for (std::size_t k = 0; k < setting.picks.size(); ++k) {
    if (study.vary.axes[k].children.size() > 1) {
      const std::string& key = study.vary.axes[k].key;
      const std::string word = key.substr(key.rfind('.') + 1);
      // "float32" and "paper" speak for themselves, "0.6" and "true" do not.
      const bool speaks = setting.picks[k].find_first_not_of("0123456789.eE+-") == 0 && setting.picks[k] != "true" &&
                          setting.picks[k] != "false";
      parts.push_back(speaks ? setting.picks[k] : word + " " + setting.picks[k]);
    }
  }
  if (study.devices.size() > 1) {
    parts.push_back(enum_name(setting.device));
  }
  if (study.threads.size() > 1) {
    parts.push_back(std::to_string(setting.threads) + (setting.threads == 1 ? " thread" : " threads"));
  }
  return join(", ", parts);
}

/// The cases come curve by curve: all but the spacing is the same within one.
std::vector<StudyCurve> curves_of(const StudyPlan& plan) {
  const auto same = [](const StudyCase& a, const StudyCase& b) {
    return a.scene == b.scene && a.method == b.method && a.picks == b.picks && a.device == b.device &&
           a.threads == b.threads;
  };
  std::vector<StudyCurve> curves;
  for (std::size_t k = 0; k < plan.cases.size(); ++k) {
    if (k == 0 || !same(plan.cases[k - 1], plan.cases[k])) {
      curves.push_back({plan.cases[k].scene, label_of(plan.study, plan.cases[k]), {}});
    }
    curves.back().points.push_back(k);
  }
  for (StudyCurve& curve : curves) {
    std::stable_sort(curve.points.begin(), curve.points.end(), [&](std::size_t a, std::size_t b) {
      return plan.cases[a].setup.grid.spacing > plan.cases[b].setup.grid.spacing;
    });
  }
  return curves;
}

double spacing_of(const StudyPoint& point) {
  return point.setting->setup.grid.spacing;
}

void observe_orders(StudyFindings& findings) {
  for (const StudyCurve& curve : findings.curves) {
    for (std::size_t k = 1; k < curve.points.size(); ++k) {
      const StudyPoint& coarse = findings.points[curve.points[k - 1]];
      StudyPoint& fine = findings.points[curve.points[k]];
      const double order = std::log(coarse.error / fine.error) / std::log(spacing_of(coarse) / spacing_of(fine));
      if (std::isfinite(order)) {
        fine.order = order;
      }
    }
  }
}

bool is_complete(const StudyPoint& point) {
  return point.seconds && std::isfinite(point.error);
}

/// Errors this close are the same: float64 often gains nothing but the last digits, at twice the time.
constexpr double same_error = 0.01;

void mark_frontier(StudyFindings& findings) {
  for (StudyPoint& point : findings.points) {
    const auto beats = [&](const StudyPoint& other) {
      if (!is_complete(other) || other.setting->scene != point.setting->scene) {
        return false;
      }
      const double seconds = *other.seconds, own = *point.seconds;
      return (seconds < own && other.error <= (1.0 + same_error) * point.error) ||
             (seconds <= own && other.error < point.error);
    };
    point.on_frontier = is_complete(point) && std::none_of(findings.points.begin(), findings.points.end(), beats);
  }
}

}  // namespace

StudyFindings analyse(const StudyPlan& plan, const std::vector<TimedResult>& results,
                      const std::vector<FineDepth>& fine) {
  StudyFindings findings;
  for (std::size_t k = 0; k < plan.cases.size(); ++k) {
    findings.points.push_back(point_of(plan, plan.cases[k], results[k], fine));
  }
  findings.curves = curves_of(plan);
  observe_orders(findings);
  mark_frontier(findings);
  return findings;
}

const StudyPoint* cheapest(const StudyFindings& findings, std::size_t scene, double target) {
  const StudyPoint* best = nullptr;
  for (const StudyPoint& point : findings.points) {
    const bool reaches = point.setting->scene == scene && is_complete(point) && point.error <= target;
    if (reaches && (best == nullptr || *point.seconds < *best->seconds)) {
      best = &point;
    }
  }
  return best;
}

std::optional<CostToError> cost_to_error(const StudyFindings& findings, const StudyCurve& curve, double target) {
  const StudyPoint* before = nullptr;
  for (const std::size_t k : curve.points) {
    const StudyPoint& point = findings.points[k];
    if (!is_complete(point)) {
      continue;
    }
    if (point.error > target) {
      before = &point;
      continue;
    }
    if (before == nullptr) {
      return CostToError{*point.seconds, point.cell_steps};
    }
    const double part = std::log(before->error / target) / std::log(before->error / point.error);
    const auto between = [part](double from, double to) { return from * std::pow(to / from, part); };
    return CostToError{between(*before->seconds, *point.seconds), between(before->cell_steps, point.cell_steps)};
  }
  return std::nullopt;
}

}  // namespace sandsim::cli
