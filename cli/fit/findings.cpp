#include "cli/fit/findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/text.hpp"
#include "io/output/json.hpp"
#include "io/output/run_report.hpp"
#include "io/output/version.hpp"

namespace sandsim::cli {

namespace {

constexpr double on_bound = 1e-3;   // fraction of the way between the bounds
constexpr double poor_fit = 3.0;    // times the tolerance: then the scene does not give the data
constexpr double wide = 0.02;       // ranges, as fractions of the bounds, that are worth a word on what goes along
constexpr double goes_along = 0.5;  // of its own range

std::string metres(double value) {
  const double size = std::abs(value);
  return size < 1e-3  ? fmt::format("{:.3g} mm", 1e3 * value)
         : size < 0.1 ? fmt::format("{:.3g} mm", 1e3 * value)
                      : fmt::format("{:.4g} m", value);
}

double fraction_of(const FitReport& report, double misfit) {
  return misfit / report.reference.signal;
}

std::string percent(double fraction) {
  return fmt::format("{:.2g} %", 100.0 * fraction);
}

std::string word_on(const FitReport& report, std::size_t k) {
  const FitParameter& parameter = report.parameters[k];
  const FitRange& range = report.result.ranges[k];
  const std::string low = parameter.shown(range.low[k]), high = parameter.shown(range.high[k]);
  const std::string best = parameter.shown(report.result.best.point[k]);
  const std::string within = metres(report.result.limit);
  const std::string others = report.parameters.size() > 1 ? ", with the others fitted again" : "";
  switch (knowledge_of(report.result, k)) {
    case Knowledge::nothing:
      return fmt::format("The data do not tell {}: any value between {} and {} fits within {}{}.", parameter.key, low,
                         high, within, others);
    case Knowledge::at_least:
      return fmt::format("The data tell only that {} is at least {}: any value up to its bound of {} fits within {}{}.",
                         parameter.key, low, high, within, others);
    case Knowledge::at_most:
      return fmt::format(
          "The data tell only that {} is at most {}: any value down to its bound of {} fits within {}{}.",
          parameter.key, high, low, within, others);
    case Knowledge::on_lower_bound:
    case Knowledge::on_upper_bound:
      return fmt::format("The best {} is its bound, {}: the optimum may lie beyond. Widen the bounds.", parameter.key,
                         best);
    case Knowledge::known:
      break;
  }
  return fmt::format("{} is {}: {} to {} fits within {}{}.", parameter.key, best, low, high, within, others);
}

/// How the others go along with a parameter, from one end of its range to the other.
std::string valley_of(const FitReport& report, std::size_t k) {
  const FitRange& range = report.result.ranges[k];
  if (range.high[k] - range.low[k] < wide) {
    return {};
  }
  std::vector<std::string> along;
  for (std::size_t m = 0; m < report.parameters.size(); ++m) {
    const double own = report.result.ranges[m].high[m] - report.result.ranges[m].low[m];
    if (m != k && own >= wide && std::abs(range.high[m] - range.low[m]) >= goes_along * own) {
      const FitParameter& other = report.parameters[m];
      along.push_back(
          fmt::format("{} from {} to {}", other.key, other.shown(range.low[m]), other.shown(range.high[m])));
    }
  }
  if (along.empty()) {
    return {};
  }
  return fmt::format("{} trades off: from {} to {} the fit stays as good if {} goes along.", report.parameters[k].key,
                     report.parameters[k].shown(range.low[k]), report.parameters[k].shown(range.high[k]),
                     join(" and ", along));
}

std::size_t failures(const FitResult& result) {
  return static_cast<std::size_t>(std::count_if(result.evaluated.begin(), result.evaluated.end(),
                                                [](const Evaluation& one) { return one.failed(); }));
}

std::string word_on_failures(const FitResult& result) {
  const auto first = std::find_if(result.evaluated.begin(), result.evaluated.end(),
                                  [](const Evaluation& one) { return one.failed(); });
  if (first == result.evaluated.end()) {
    return {};
  }
  return fmt::format("{} of {} runs failed and count as a large misfit (see fit.csv); the first: {}", failures(result),
                     result.evaluated.size(), first->message);
}

const char* name_of(Origin::Stage stage) {
  constexpr const char* names[] = {"start", "search", "range", "map"};
  return names[static_cast<int>(stage)];
}

const char* name_of(Knowledge knowledge) {
  constexpr const char* names[] = {"known",   "at least",           "at most",
                                   "nothing", "on its lower bound", "on its upper bound"};
  return names[static_cast<int>(knowledge)];
}

std::string yaml_parameter(const FitReport& report, std::size_t k) {
  const FitParameter& parameter = report.parameters[k];
  const FitRange& range = report.result.ranges[k];
  return fmt::format(
      "  - key: {}\n    best: {}\n    fits_equally_well: {{from: {}, to: {}}}\n    bounds: {{from: {}, to: {}}}\n"
      "    data_tell: {}\n",
      parameter.key, parameter.text(report.result.best.point[k]), parameter.text(range.low[k]),
      parameter.text(range.high[k]), parameter.text(0.0), parameter.text(1.0), name_of(knowledge_of(report.result, k)));
}

}  // namespace

Knowledge knowledge_of(const FitResult& result, std::size_t k) {
  const bool low = result.ranges[k].low[k]<on_bound, high = result.ranges[k].high[k]> 1.0 - on_bound;
  const double best = result.best.point[k];
  if (low && high) {
    return Knowledge::nothing;
  }
  if (low && best < on_bound) {
    return Knowledge::on_lower_bound;
  }
  if (high && best > 1.0 - on_bound) {
    return Knowledge::on_upper_bound;
  }
  return low ? Knowledge::at_most : high ? Knowledge::at_least : Knowledge::known;
}

std::vector<std::string> fit_words(const FitReport& report) {
  std::vector<std::string> words;
  const double best = report.result.best.misfit;
  const double tolerance = std::sqrt(std::max(0.0, report.result.limit * report.result.limit - best * best));
  if (best > poor_fit * tolerance) {
    words.push_back(
        fmt::format("The scene does not give the data: even the best fit is {} off, {} of the {}. The "
                    "ranges are those of the fit, and no errors of the values.",
                    metres(best), percent(fraction_of(report, best)), report.reference.signal_name()));
  }
  for (std::size_t k = 0; k < report.parameters.size(); ++k) {
    words.push_back(word_on(report, k));
  }
  for (std::size_t k = 0; k < report.parameters.size(); ++k) {
    words.push_back(valley_of(report, k));
  }
  words.push_back(word_on_failures(report.result));
  std::erase(words, "");
  return words;
}

std::string fit_summary(const FitReport& report) {
  const FitResult& result = report.result;
  std::string text = fmt::format("{}: {}\n", report.scene, report.reference.description());
  std::size_t width = 9;
  for (const FitParameter& parameter : report.parameters) {
    width = std::max(width, parameter.key.size());
  }
  text += fmt::format("  {:<{}}  {:>12}  {:>26}  {:>22}\n", "parameter", width, "best", "fits equally well", "bounds");
  for (std::size_t k = 0; k < report.parameters.size(); ++k) {
    const FitParameter& parameter = report.parameters[k];
    const FitRange& range = result.ranges[k];
    text +=
        fmt::format("  {:<{}}  {:>12}  {:>26}  {:>22}\n", parameter.key, width, parameter.shown(result.best.point[k]),
                    parameter.shown(range.low[k]) + " .. " + parameter.shown(range.high[k]),
                    parameter.shown(0.0) + " .. " + parameter.shown(1.0));
  }
  text +=
      fmt::format("  misfit {}, {} of the {} ({}); up to {} counts as equally good: {}\n", metres(result.best.misfit),
                  percent(fraction_of(report, result.best.misfit)), report.reference.signal_name(),
                  metres(report.reference.signal), metres(result.limit), report.tolerance_reason);
  text += fmt::format("  {} runs in {}, {} failed\n", result.evaluated.size(), format_duration(report.seconds),
                      failures(result));
  for (const std::string& word : fit_words(report)) {
    text += "  * " + word + '\n';
  }
  return text;
}

std::string fit_yaml(const FitReport& report) {
  const FitResult& result = report.result;
  std::string text = fmt::format("# Written by sandsim fit.\nsource: {}\nwritten: {}\ncommand: {}\nscene: {}\n",
                                 json_string(source_line()), time_stamp(), json_string(report.command_line),
                                 json_string(report.scene));
  text += fmt::format("reference:\n  from: {}\n  kind: {}\n  points: {}\n  signal: {:.9g} m\n",
                      json_string(report.reference.source),
                      report.reference.kind == FitReference::Kind::front ? "front" : "profile",
                      report.reference.place.size(), report.reference.signal);
  text += report.reference.kind == FitReference::Kind::front
              ? fmt::format("  front_depth: {:.9g} m\n", report.reference.front_depth)
              : fmt::format("  time: {:.9g} s\n", report.reference.time);
  text += fmt::format("misfit: {:.9g} m\nequally_good_up_to: {:.9g} m\nruns: {}\nfailed: {}\nwall_time: {:.4g} s\n",
                      result.best.misfit, result.limit, result.evaluated.size(), failures(result), report.seconds);
  text += "parameters:\n";
  for (std::size_t k = 0; k < report.parameters.size(); ++k) {
    text += yaml_parameter(report, k);
  }
  text += "findings:\n";
  for (const std::string& word : fit_words(report)) {
    text += "  - " + json_string(word) + '\n';
  }
  return text;
}

Table fit_table(const std::vector<FitParameter>& parameters, const std::vector<Evaluation>& evaluations,
                const FitReference& reference) {
  std::vector<std::int64_t> numbers;
  std::vector<std::string> stages, statuses, messages;
  std::vector<double> misfits, relative, seconds;
  for (const Evaluation& one : evaluations) {
    numbers.push_back(static_cast<std::int64_t>(numbers.size() + 1));
    stages.push_back(name_of(one.origin.stage));
    misfits.push_back(one.misfit);
    relative.push_back(one.misfit / reference.signal);
    statuses.push_back(one.status);
    messages.push_back(one.message);
    seconds.push_back(one.seconds);
  }
  Table table;
  table.dimension = "run";
  table.columns.push_back({"run", "", "number of the run", "", std::move(numbers)});
  table.columns.push_back({"stage", "", "part of the fit", "", std::move(stages)});
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    std::vector<double> values;
    for (const Evaluation& one : evaluations) {
      values.push_back(parameters[k].value(one.point[k]));
    }
    table.columns.push_back({parameters[k].key, parameters[k].unit(), "varied value", "parameter", std::move(values)});
  }
  table.columns.push_back({"misfit", "m", "root mean square difference", "metric", std::move(misfits)});
  table.columns.push_back({"misfit_relative", "", "misfit over the signal", "metric", std::move(relative)});
  table.columns.push_back({"status", "", "how the run ended", "", std::move(statuses)});
  table.columns.push_back({"message", "", "why there is no misfit", "", std::move(messages)});
  table.columns.push_back({"wall_time", "s", "wall-clock time of the run", "", std::move(seconds)});
  return table;
}

}  // namespace sandsim::cli
