#include "cli/study/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "cli/study/text_table.hpp"
#include "cli/text.hpp"
#include "io/study/study_parameters.hpp"

namespace sandsim::cli {

namespace {

std::string length_text(double metres) {
  return metres < 0.00995 ? fmt::format("{:.6g} mm", 1e3 * metres)
         : metres < 0.995 ? fmt::format("{:.6g} cm", 1e2 * metres)
                          : fmt::format("{:.6g} m", metres);
}

double spacing_of(const StudyPoint& point) {
  return point.setting->setup.grid.spacing;
}

std::string measure_text(ErrorMeasure measure) {
  switch (measure) {
    case ErrorMeasure::l1:
      return "L1 error of the depth [m^2, in 2-D m^3]";
    case ErrorMeasure::l2:
      return "L2 error of the depth [m^1.5, in 2-D m^2]";
    case ErrorMeasure::linf:
      return "largest error of the depth [m]";
    case ErrorMeasure::front:
      return "error of the front [m]";
    case ErrorMeasure::height:
      return "error of the largest depth [m]";
    case ErrorMeasure::volume:
      return "relative error of the volume";
    case ErrorMeasure::l1_relative:
      break;
  }
  return "relative L1 error of the depth";
}

/// The spacings of a scene's points, coarse to fine.
std::vector<double> spacings_of(const StudyFindings& findings, std::size_t scene) {
  std::set<double, std::greater<>> all;
  for (const StudyPoint& point : findings.points) {
    if (point.setting->scene == scene) {
      all.insert(spacing_of(point));
    }
  }
  return {all.begin(), all.end()};
}

const StudyPoint* point_at(const StudyFindings& findings, const StudyCurve& curve, double spacing) {
  for (const std::size_t k : curve.points) {
    if (spacing_of(findings.points[k]) == spacing) {
      return &findings.points[k];
    }
  }
  return nullptr;
}

std::string cell_text(const StudyPoint& point) {
  if (point.result->failed()) {
    return "failed";
  }
  const std::string error = std::isfinite(point.error) ? fmt::format("{:.2e}", point.error) : "-";
  const std::string time = point.seconds ? format_duration(*point.seconds) : "-";
  const char* mark = point.on_frontier ? "**" : "";
  return fmt::format("{}{} ({}){}", mark, error, time, mark);
}

std::string orders_text(const StudyFindings& findings, const StudyCurve& curve) {
  std::vector<std::string> orders;
  for (const std::size_t k : curve.points) {
    if (findings.points[k].order) {
      orders.push_back(fmt::format("{:.2f}", *findings.points[k].order));
    }
  }
  return orders.empty() ? "-" : join(" ", orders);
}

TextTable error_table(const StudyPlan& plan, const StudyFindings& findings, std::size_t scene) {
  const std::vector<double> spacings = spacings_of(findings, scene);
  TextTable table;
  table.head.emplace_back("setting");
  for (const double spacing : spacings) {
    table.head.push_back(length_text(spacing));
  }
  table.head.emplace_back("observed orders");
  for (const double target : plan.study.under) {
    table.head.push_back(fmt::format("time to {:g}", target));
    table.head.push_back(fmt::format("cell-steps to {:g}", target));
  }
  for (const StudyCurve& curve : findings.curves) {
    if (curve.scene != scene) {
      continue;
    }
    std::vector<std::string> row{curve.label};
    for (const double spacing : spacings) {
      const StudyPoint* point = point_at(findings, curve, spacing);
      row.push_back(point == nullptr ? "-" : cell_text(*point));
    }
    row.push_back(orders_text(findings, curve));
    for (const double target : plan.study.under) {
      const auto cost = cost_to_error(findings, curve, target);
      row.push_back(cost ? format_duration(cost->seconds) : "never");
      row.push_back(cost ? fmt::format("{:.2e}", cost->cell_steps) : "never");
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// " against ...", by the first setting that has an error.
std::string against_text(const StudyPlan& plan, const StudyFindings& findings, std::size_t scene) {
  for (const StudyPoint& point : findings.points) {
    if (point.setting->scene == scene && point.against) {
      return " against " + point.against->against +
             (plan.study.fine ? " with cells of " + length_text(plan.study.fine->spacing) : "");
    }
  }
  return "";
}

std::string label_of(const StudyFindings& findings, const StudyPoint& point) {
  for (const StudyCurve& curve : findings.curves) {
    for (const std::size_t k : curve.points) {
      if (&findings.points[k] == &point) {
        return curve.label;
      }
    }
  }
  return "";
}

std::vector<std::string> setting_row(const StudyFindings& findings, const StudyPoint& point) {
  return {label_of(findings, point),
          length_text(spacing_of(point)),
          fmt::format("{:.3e}", point.error),
          format_duration(*point.seconds),
          format_duration(point.times.least) + " - " + format_duration(point.times.most),
          fmt::format("{:.2e}", point.cell_steps)};
}

const std::vector<std::string> setting_head{"setting", "spacing", "error", "time", "from - to", "cell-steps"};

std::string frontier_text(const StudyFindings& findings, std::size_t scene) {
  std::vector<const StudyPoint*> points;
  for (const StudyPoint& point : findings.points) {
    if (point.setting->scene == scene && point.on_frontier) {
      points.push_back(&point);
    }
  }
  if (points.size() < 2) {
    return "";
  }
  std::sort(points.begin(), points.end(),
            [](const StudyPoint* a, const StudyPoint* b) { return *a->seconds < *b->seconds; });
  TextTable table{setting_head, {}};
  for (const StudyPoint* point : points) {
    table.rows.push_back(setting_row(findings, *point));
  }
  return "\nFrontier (nothing faster has an error at most 1 % larger):\n\n" + markdown(table);
}

std::string cheapest_text(const StudyPlan& plan, const StudyFindings& findings, std::size_t scene) {
  std::string text;
  for (const double target : plan.study.under) {
    const StudyPoint* best = cheapest(findings, scene, target);
    text += fmt::format("\nCheapest setting measured with an error of at most {:g}: ", target);
    if (best == nullptr) {
      text += "none.\n";
      continue;
    }
    const std::string label = label_of(findings, *best);
    text += fmt::format("{}{}{}, error {:.3e} in {}.\n", label, label.empty() ? "" : ", ",
                        length_text(spacing_of(*best)), best->error, format_duration(*best->seconds));
  }
  return text;
}

std::string ablation_text(const std::vector<AblationRow>& rows) {
  const auto with_range = [](const Measurement& ratio) {
    return fmt::format("{:.3f} ({:.3f} - {:.3f})", ratio.median, ratio.least, ratio.most);
  };
  TextTable table{{"variant", "whole run", "over base", "ns a cell-step", "over base", "bytes a cell-step", "memory",
                   "steps", "stages"},
                  {}};
  for (const AblationRow& row : rows) {
    table.rows.push_back({row.name, format_duration(row.wall.median), with_range(row.wall_ratio),
                          fmt::format("{:.3g}", row.nanoseconds.median), with_range(row.ratio),
                          fmt::format("{:.4g}", row.bytes_per_cell_step),
                          format_bytes(static_cast<double>(row.report->memory_bytes)), format_count(row.report->steps),
                          row.stages});
  }
  return "\n## What features cost\n\nRatios: median over the rounds (least - most). A whole run includes its start and "
         "its output; a cell-step is the solver alone.\n\n" +
         markdown(table);
}

std::string head_text(const StudyPlan& plan, const StudySetting& setting) {
  std::string text = "# " + (plan.study.title.empty() ? std::string("Study") : plan.study.title) + "\n\n";
  text += fmt::format("{}; {}. Times: of the solver's steps, {} of {} after a warm-up, one run after the other. ",
                      setting.machine, setting.date, enum_name(plan.study.times), setting.repeats);
  text += fmt::format("Load average {:.2f} before and {:.2f} after, on {} processors.\n", setting.load_before,
                      setting.load_after, setting.processors);
  for (const std::string& remark : setting.remarks) {
    text += "\n- " + remark;
  }
  return text + (setting.remarks.empty() ? "" : "\n");
}

// ---- CSV ------------------------------------------------------------------------------------------------------------
std::string number(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? fmt::format("{}", *value) : "";
}

std::vector<std::string> csv_head(const StudyPlan& plan) {
  std::vector<std::string> head{"scene", "setting", "method"};
  for (const Node& axis : plan.study.vary.axes) {
    head.push_back(axis.key);
  }
  const std::vector<std::string> rest{
      "device",  "threads", "spacing_m", "cells",       "steps",       "cell_steps", "seconds", "least_s", "most_s",
      "repeats", "bytes",   "error",     "l1_relative", "l1",          "l2",         "linf_m",  "front_m", "height_m",
      "volume",  "order",   "frontier",  "at_rest",     "simulated_s", "against",    "status",  "note"};
  head.insert(head.end(), rest.begin(), rest.end());
  return head;
}

std::vector<std::string> csv_row(const StudyPlan& plan, const StudyFindings& findings, const StudyPoint& point) {
  const RunReport& report = point.result->report;
  std::vector<std::string> row{plan.study.scenes[point.setting->scene].name, label_of(findings, point),
                               point.setting->method};
  row.insert(row.end(), point.setting->picks.begin(), point.setting->picks.end());
  const auto time = [&](double Measurement::*which) { return point.seconds ? number(point.times.*which) : ""; };
  const auto norm = [&](std::optional<double> ErrorReport::*which) {
    return point.against ? number((*point.against).*which) : "";
  };
  const std::vector<std::string> rest{report.device,
                                      std::to_string(report.threads),
                                      number(spacing_of(point)),
                                      std::to_string(report.cells),
                                      std::to_string(report.steps),
                                      number(point.cell_steps),
                                      number(point.seconds),
                                      time(&Measurement::least),
                                      time(&Measurement::most),
                                      std::to_string(point.result->solving.size()),
                                      number(point.bytes),
                                      number(point.error),
                                      norm(&ErrorReport::l1_relative),
                                      norm(&ErrorReport::l1),
                                      norm(&ErrorReport::l2),
                                      norm(&ErrorReport::linf),
                                      number(point.front_error),
                                      number(point.height_error),
                                      number(point.volume_error),
                                      number(point.order),
                                      point.on_frontier ? "true" : "false",
                                      report.at_rest ? "true" : "false",
                                      number(report.simulated_time),
                                      point.against ? point.against->against : "",
                                      report.status,
                                      point.note};
  row.insert(row.end(), rest.begin(), rest.end());
  return row;
}

}  // namespace

std::string study_markdown(const StudyPlan& plan, const StudyFindings& findings,
                           const std::vector<AblationRow>& ablation, const StudySetting& setting) {
  std::string text = head_text(plan, setting);
  for (std::size_t scene = 0; scene < plan.study.scenes.size(); ++scene) {
    text += "\n## " + plan.study.scenes[scene].name + "\n\n";
    text += measure_text(plan.study.error.measure) + against_text(plan, findings, scene) +
            " (time); the frontier in bold.\n\n";
    text += markdown(error_table(plan, findings, scene));
    text += frontier_text(findings, scene);
    text += cheapest_text(plan, findings, scene);
  }
  return text + (ablation.empty() ? "" : ablation_text(ablation));
}

std::string study_csv(const StudyPlan& plan, const StudyFindings& findings) {
  TextTable table{csv_head(plan), {}};
  for (const StudyPoint& point : findings.points) {
    table.rows.push_back(csv_row(plan, findings, point));
  }
  return csv(table);
}

std::string ablation_csv(const std::vector<AblationRow>& rows) {
  TextTable table{{"variant", "wall_s", "wall_least_s", "wall_most_s", "wall_ratio", "wall_ratio_least",
                   "wall_ratio_most", "step_ns", "step_least_ns", "step_most_ns", "ratio", "ratio_least", "ratio_most",
                   "bytes_per_cell_step", "memory_bytes", "cells", "steps", "stages"},
                  {}};
  for (const AblationRow& row : rows) {
    std::vector<std::string> cells{row.name};
    for (const Measurement& measured : {row.wall, row.wall_ratio, row.nanoseconds, row.ratio}) {
      for (const double value : {measured.median, measured.least, measured.most}) {
        cells.push_back(number(value));
      }
    }
    for (const std::string& text : {number(row.bytes_per_cell_step), std::to_string(row.report->memory_bytes),
                                    std::to_string(row.report->cells), std::to_string(row.report->steps), row.stages}) {
      cells.push_back(text);
    }
    table.rows.push_back(std::move(cells));
  }
  return csv(table);
}

}  // namespace sandsim::cli
