#include "cli/sweep/sweep_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "io/output/run_report.hpp"
#include "io/output/version.hpp"

namespace sandsim::cli {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

Column text_column(const std::string& name, const std::string& long_name, const std::vector<CaseState>& states,
                   const std::function<std::string(const CaseState&)>& value) {
  std::vector<std::string> values;
  for (const CaseState& state : states) {
    values.push_back(value(state));
  }
  return {name, "", long_name, "", std::move(values)};
}

/// A varied key: numbers if all its values are numbers with the same unit.
Column parameter_column(const Sweep& sweep, std::size_t key) {
  Column column{sweep.keys[key], "", "varied value of " + sweep.keys[key], "parameter", {}};
  std::vector<double> numbers;
  std::vector<std::string> texts;
  for (const SweepCase& one : sweep.cases) {
    texts.push_back(one.values[key]);
    const std::optional<NumberWithUnit> number = number_with_unit(one.values[key]);
    if (!number || (!numbers.empty() && number->unit != column.units)) {
      continue;
    }
    column.units = number->unit;
    numbers.push_back(number->number);
  }
  if (numbers.size() == texts.size()) {
    column.values = std::move(numbers);
  } else {
    column.units.clear();
    column.values = std::move(texts);
  }
  return column;
}

using Metric = std::function<double(const CaseReport&)>;

void add_metric(Table& table, const std::vector<CaseState>& states, const std::string& name, const std::string& units,
                const std::string& long_name, const Metric& metric) {
  std::vector<double> values;
  for (const CaseState& state : states) {
    // What ended before its first step has a report, but of nothing.
    const bool has_run = state.report && (state.report->run.steps > 0 || state.kind == CaseState::Kind::done);
    values.push_back(has_run ? metric(*state.report) : none);
  }
  const bool given = std::any_of(values.begin(), values.end(), [](double value) { return !std::isnan(value); });
  if (given) {
    table.columns.push_back({name, units, long_name, "metric", std::move(values)});
  }
}

template <class Value>
Metric of_runout(Value value) {
  return [value](const CaseReport& report) { return report.run.runout ? value(*report.run.runout) : none; };
}

Metric of_error(std::optional<double> ErrorReport::*norm) {
  return [norm](const CaseReport& report) {
    for (const ErrorReport& error : report.run.errors) {
      if (error.*norm) {
        return *(error.*norm);
      }
    }
    return none;
  };
}

double front_error(const CaseReport& report) {
  for (const ErrorReport& error : report.run.errors) {
    for (const ErrorReport::Front& front : error.fronts) {
      if (front.reference) {
        return front.computed - *front.reference;
      }
    }
  }
  return none;
}

double height_error(const CaseReport& report) {
  for (const ErrorReport& error : report.run.errors) {
    if (error.height) {
      return error.height->computed - error.height->reference;
    }
  }
  return none;
}

/// Norms of a depth over a plane have a length more than over a line; none if the cases differ in this.
std::string norm_units(const std::vector<CaseState>& states, const char* line, const char* plane) {
  bool has_line = false, has_plane = false;
  for (const CaseState& state : states) {
    if (state.report && state.kind == CaseState::Kind::done) {
      (state.report->has_one_row ? has_line : has_plane) = true;
    }
  }
  return has_line && has_plane ? "" : has_line ? line : plane;
}

/// What run.json has under `runout`. A front exists where some sand is left.
template <class Add>
void add_runout(const Add& add) {
  using Report = const RunoutReport&;
  add("front", "m", "largest x of the deposit", of_runout([](Report r) { return r.deposit_front; }));
  add("deposit_height", "m", "largest depth at the end", of_runout([](Report r) { return r.deposit_height; }));
  add("runout", "m", "distance of the farthest new ground under the deposit from the top of the release",
      of_runout([](Report r) { return r.front.distance; }));
  add("drop", "m", "its elevation below the top of the release", of_runout([](Report r) { return r.front.drop; }));
  add("travel_angle", "rad", "atan(drop/runout)", of_runout([](Report r) { return r.front.travel_angle(); }));
  add("center_distance", "m", "horizontal way of the centre of mass",
      of_runout([](Report r) { return r.center_of_mass.distance; }));
  add("center_drop", "m", "drop of the centre of mass", of_runout([](Report r) { return r.center_of_mass.drop; }));
  add("center_travel_angle", "rad", "atan(center_drop/center_distance)",
      of_runout([](Report r) { return r.center_of_mass.travel_angle(); }));
  add("area", "m^2", "area of the cells that sand has reached", of_runout([](Report r) { return r.area; }));
  add("max_depth", "m", "largest depth of the run", of_runout([](Report r) { return r.max_depth; }));
  add("max_speed", "m/s", "largest speed of the run", of_runout([](Report r) { return r.max_speed; }));
}

void add_metrics(Table& table, const std::vector<CaseState>& states) {
  const auto add = [&](const char* name, const std::string& units, const std::string& long_name, const Metric& metric) {
    add_metric(table, states, name, units, long_name, metric);
  };
  add_runout(add);
  add("volume_out", "m^3", "volume that left through open sides",
      [](const CaseReport& report) { return report.run.ledger.out; });
  add("stop_time", "s", "first moment from which nothing moved; none if the run ended before",
      [](const CaseReport& report) { return report.run.at_rest ? report.run.stop_time : none; });
  add("error_l1", norm_units(states, "m^2", "m^3"), "L1 error against the first reference that has one",
      of_error(&ErrorReport::l1));
  add("error_l2", norm_units(states, "m^1.5", "m^2"), "L2 error against the first reference that has one",
      of_error(&ErrorReport::l2));
  add("error_linf", "m", "largest error against the first reference that has one", of_error(&ErrorReport::linf));
  add("error_l1_relative", "1", "L1 error over the norm of the first reference", of_error(&ErrorReport::l1_relative));
  add("error_front", "m", "front minus that of the first reference that has one", front_error);
  add("error_height", "m", "deepest sand minus that of the first reference that has one", height_error);
  add("volume_error", "1", "relative drift of the volume",
      [](const CaseReport& report) { return report.run.ledger.error(); });
  add("max_slope_violation", "1", "steepest face over what friction holds, minus 1, at the end",
      [](const CaseReport& report) { return report.run.at_rest ? report.run.max_slope_violation : none; });
  add("simulated_time", "s", "simulated time", [](const CaseReport& report) { return report.run.simulated_time; });
  add("steps", "1", "time steps", [](const CaseReport& report) { return static_cast<double>(report.run.steps); });
  add("wall_time", "s", "wall-clock time of the run", [](const CaseReport& report) { return report.run.wall_time; });
}

}  // namespace

Table sweep_table(const Sweep& sweep, const std::vector<CaseState>& states, const std::string& command_line) {
  Table table;
  table.dimension = "case";
  std::vector<std::int64_t> numbers, codes;
  std::vector<std::string> folders;
  for (std::size_t k = 0; k < states.size(); ++k) {
    numbers.push_back(static_cast<std::int64_t>(k + 1));
    codes.push_back(states[k].exit_code);
    folders.push_back(sweep.cases[k].folder);
  }
  table.columns.push_back({"case", "", "number of the case", "", std::move(numbers)});
  for (std::size_t key = 0; key < sweep.keys.size(); ++key) {
    table.columns.push_back(parameter_column(sweep, key));
  }
  table.columns.push_back(
      text_column("status", "how the run ended", states, [](const CaseState& state) { return state.status; }));
  table.columns.push_back({"exit_code", "", "exit code of the run", "", std::move(codes)});
  add_metrics(table, states);
  table.columns.push_back(
      text_column("message", "why a run failed", states, [](const CaseState& state) { return state.message; }));
  table.columns.push_back({"folder", "", "folder of the results", "", std::move(folders)});
  table.attributes = {{"Conventions", "CF-1.10"},
                      {"title", "Sweep of " + sweep.scene.string()},
                      {"source", source_line()},
                      {"history", time_stamp() + " " + command_line},
                      {"scene_file", sweep.scene.string()}};
  return table;
}

}  // namespace sandsim::cli
