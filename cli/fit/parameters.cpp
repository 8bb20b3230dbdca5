#include "cli/fit/parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/scene/node.hpp"
#include "io/sweep/plan.hpp"
#include "solver/errors.hpp"

namespace sandsim::cli {

namespace {

[[noreturn]] void usage(const std::string& subject, const std::string& message) {
  throw Error(ExitCode::usage, subject + ": " + message);
}

/// A sweep's interval has dots: "0.3:1" means "0.3..1" here, and "1:20 cm:log" means "1..20 cm:log".
std::string with_dots(const std::string& text) {
  if (text.find("..") != std::string::npos) {
    return text;
  }
  const std::size_t colon = text.find(':');
  return colon == std::string::npos ? text : text.substr(0, colon) + ".." + text.substr(colon + 1);
}

FitParameter read_parameter(const std::string& text) {
  const std::string subject = "--vary " + shown(text, 200);
  const std::string form = "Write it like \"sand.hbar.cap=1:20 cm\"";
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    usage(subject, "not of the form key=first:last. " + form + ".");
  }
  const Parsed<SweepValues> parsed = parse_sweep_values(with_dots(text.substr(equals + 1)));
  if (const Complaint* complaint = std::get_if<Complaint>(&parsed)) {
    usage(subject, fmt::format("{}{}. {}.", complaint->problem,
                               complaint->why.empty() ? "" : " (" + complaint->why + ")", form));
  }
  const Interval* interval = std::get_if<Interval>(&std::get<SweepValues>(parsed));
  if (interval == nullptr) {
    usage(subject, "no interval (a fit looks for the best value between two bounds). " + form + ".");
  }
  if (interval->first > interval->last) {
    usage(subject, fmt::format("the bounds are reversed. Write {}={:g}:{:g}{}.", text.substr(0, equals), interval->last,
                               interval->first, interval->unit.empty() ? "" : ' ' + interval->unit));
  }
  return {text.substr(0, equals), *interval};
}

}  // namespace

std::string FitParameter::shown(double at) const {
  return fmt::format("{:.4g}{}", value(at), bounds.unit.empty() ? "" : ' ' + bounds.unit);
}

double FitParameter::fraction(double of) const {
  const double raw = bounds.logarithmic ? std::log(of / bounds.first) / std::log(bounds.last / bounds.first)
                                        : (of - bounds.first) / (bounds.last - bounds.first);
  return std::clamp(raw, 0.0, 1.0);
}

std::vector<FitParameter> read_fit_parameters(const std::vector<std::string>& vary,
                                              const std::vector<std::string>& overrides) {
  std::vector<FitParameter> parameters;
  for (const std::string& text : vary) {
    FitParameter parameter = read_parameter(text);
    const auto same = [&](const FitParameter& other) { return other.key == parameter.key; };
    if (std::any_of(parameters.begin(), parameters.end(), same)) {
      usage("--vary " + shown(text, 200), "'" + parameter.key + "' varies twice. Remove one of the two.");
    }
    const auto sets = [&](const std::string& set) { return set.substr(0, set.find('=')) == parameter.key; };
    if (std::any_of(overrides.begin(), overrides.end(), sets)) {
      usage("--vary " + shown(text, 200), "'" + parameter.key + "' is both set and varied. Remove one of the two.");
    }
    parameters.push_back(std::move(parameter));
  }
  if (parameters.empty()) {
    usage("fit", "nothing varies. Say what is looked for, between which bounds: --vary sand.hbar.scale=0.3:1.");
  }
  return parameters;
}

std::vector<std::string> values_at(const std::vector<FitParameter>& parameters, const FitPoint& point) {
  std::vector<std::string> values;
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    values.push_back(parameters[k].text(point[k]));
  }
  return values;
}

void require_valid_bounds(const Sweep& base, const std::vector<FitParameter>& parameters) {
  // The point between is no round number, which a key for whole numbers has to refuse.
  for (const double fraction : {0.0, 1.0, 0.3819660112501051}) {
    const SweepCase one = resolve_case(base, values_at(parameters, FitPoint(parameters.size(), fraction)));
    if (!one.problem.empty()) {
      throw SceneError(one.problem);
    }
  }
}

std::vector<FitPoint> hypercube(const std::vector<FitParameter>& parameters, int count, std::uint64_t seed) {
  SweepPlan plan;
  for (const FitParameter& parameter : parameters) {
    plan.sampled.push_back({parameter.key, parameter.bounds});
  }
  plan.samples = {count, Sampling::latin, seed};
  std::vector<FitPoint> points;
  for (const std::vector<std::string>& values : plan.cases()) {
    FitPoint point;
    for (std::size_t k = 0; k < parameters.size(); ++k) {
      point.push_back(parameters[k].fraction(number_with_unit(values[k])->number));
    }
    points.push_back(std::move(point));
  }
  return points;
}

}  // namespace sandsim::cli
