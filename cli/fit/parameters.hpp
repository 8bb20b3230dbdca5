// What a fit varies: keys of the scene between two bounds.
#pragma once

#include <string>
#include <vector>

#include "cli/sweep/sweep.hpp"
#include "io/sweep/values.hpp"

namespace sandsim::cli {

/// One point: a fraction of the way from lower to upper bound for each parameter, 0 to 1.
using FitPoint = std::vector<double>;

struct FitParameter {
  std::string key;
  Interval bounds;  // first < last

  double value(double fraction) const { return bounds.at(fraction); }
  std::string unit() const { return bounds.unit; }
  /// As a scene writes it: "4.2 cm".
  std::string text(double fraction) const { return sweep_value_text(value(fraction), bounds.unit); }
  /// For people: four significant digits.
  std::string shown(double fraction) const;
  double fraction(double value) const;
};

/// Reads "key=first:last unit", "key=first..last unit", each also with ":log". Throws Error with exit code 1: what is
/// no interval, bounds in the wrong order, mixed units, a key that varies twice or is set as well, nothing that varies.
std::vector<FitParameter> read_fit_parameters(const std::vector<std::string>& vary,
                                              const std::vector<std::string>& overrides);

/// What `--set` would have to say for a point.
std::vector<std::string> values_at(const std::vector<FitParameter>& parameters, const FitPoint& point);

/// Throws SceneError unless the scene is valid at both ends and in between.
void require_valid_bounds(const Sweep& base, const std::vector<FitParameter>& parameters);

/// `count` points of a Latin hypercube; the same seed gives the same points everywhere.
std::vector<FitPoint> hypercube(const std::vector<FitParameter>& parameters, int count, std::uint64_t seed);

}  // namespace sandsim::cli
