#include "cli/stress/criteria.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <sstream>

namespace sandsim::cli {

namespace {

/// The members of a measurement in the order of its text; the message comes last.
template <class Measured, class Visitor>
void visit_numbers(Measured& m, const Visitor& visit) {
  visit(m.exit_code);
  visit(m.is_finite);
  visit(m.is_positive);
  visit(m.is_repeated);
  visit(m.is_unchanged);
  visit(m.at_rest);
  visit(m.slope_violation);
  visit(m.steps);
  visit(m.volume_error);
  visit(m.max_speed);
  visit(m.dt_min);
  visit(m.energy_speed);
  visit(m.spacing);
  visit(m.wall_time);
}

std::string first_line(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

/// How the run ended, if it should not have.
void judge_ending(const Measurement& measured, const Criteria& criteria, std::vector<Finding>& findings) {
  const int wanted = static_cast<int>(criteria.ending);
  if (measured.exit_code != wanted) {
    findings.push_back({"ending", fmt::format("exit code {} instead of {}{}{}", measured.exit_code, wanted,
                                              measured.message.empty() ? "" : ": ", first_line(measured.message))});
  } else if (measured.message.find(criteria.message) == std::string::npos) {
    findings.push_back(
        {"ending", fmt::format("the message does not say '{}': {}", criteria.message, first_line(measured.message))});
  }
}

}  // namespace

double Measurement::relative_speed() const {
  return max_speed == 0.0 ? 0.0 : max_speed / energy_speed;
}

double Measurement::relative_step() const {
  return dt_min * energy_speed / spacing;
}

std::string Measurement::encode() const {
  std::string text;
  visit_numbers(*this, [&](const auto& value) { text += fmt::format("{} ", static_cast<double>(value)); });
  return text + message;
}

Measurement Measurement::decode(const std::string& text) {
  Measurement measured;
  const char* at = text.c_str();
  visit_numbers(measured, [&](auto& value) {
    char* end = nullptr;
    value = static_cast<std::decay_t<decltype(value)>>(std::strtod(at, &end));  // takes "inf" and "nan" as well
    at = end;
  });
  measured.message = *at == ' ' ? at + 1 : at;
  return measured;
}

std::vector<Finding> judge(const Measurement& measured, const Criteria& criteria, Precision precision) {
  std::vector<Finding> findings;
  const auto require = [&](bool holds, const char* criterion, const std::string& what) {
    if (!holds) {
      findings.push_back({criterion, what});
    }
  };
  judge_ending(measured, criteria, findings);
  require(measured.is_finite, "finite", "a depth or momentum is not finite");
  require(measured.is_positive, "depth", "a depth is negative");
  require(measured.is_repeated, "repeat", "a second run has other bits");
  if (criteria.ending != ExitCode::done || measured.exit_code != 0) {
    return findings;
  }
  const double volume = precision == Precision::float32 ? criteria.volume_float32 : criteria.volume_float64;
  require(std::abs(measured.volume_error) <= volume, "volume",
          fmt::format("volume error {:.1e}, at most {:.0e}", measured.volume_error, volume));
  require(criteria.speed == 0.0 || measured.relative_speed() <= criteria.speed, "speed",
          fmt::format("{:.3g} m/s = {:.3g} E, at most {:g} E", measured.max_speed, measured.relative_speed(),
                      criteria.speed));
  const bool has_step = criteria.step > 0.0 && measured.steps > 0 && measured.energy_speed > 0.0;
  require(!has_step || measured.relative_step() >= criteria.step, "step",
          fmt::format("{:.1e} s = {:.2g} dx/E, at least {:g} dx/E", measured.dt_min, measured.relative_step(),
                      criteria.step));
  require(!criteria.rest_kept || measured.is_unchanged, "rest",
          fmt::format("sand at rest has moved, at {:.1e} m/s at most", measured.max_speed));
  require(!criteria.stops || measured.at_rest, "stops", "the sand has not come to rest");
  require(!criteria.stops || !measured.at_rest || measured.slope_violation <= resting_excess, "stops",
          fmt::format("a face at rest is {:.1f} % steeper than friction holds", 100.0 * measured.slope_violation));
  return findings;
}

}  // namespace sandsim::cli
