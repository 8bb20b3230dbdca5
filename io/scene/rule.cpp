#include "io/scene/rule.hpp"

#include <numbers>

namespace sandsim {

namespace {

double si(double bound, Dimension dimension) {
  return dimension == Dimension::angle ? bound * std::numbers::pi / 180 : bound;
}

std::string bound_text(double bound, Dimension dimension) {
  return dimension == Dimension::angle ? shortest_text(bound) + " deg" : quantity_text(bound, dimension);
}

}  // namespace

std::string Rule::bounds_text() const {
  std::string result;
  if (low > -infinity) result = (low_excluded ? "above " : "at least ") + bound_text(low, dimension);
  if (high < infinity) {
    if (!result.empty()) result += " and ";
    result += (high_excluded ? "below " : "at most ") + bound_text(high, dimension);
  }
  return result;
}

bool Rule::holds(double value) const {
  const double lowest = si(low, dimension);
  const double highest = si(high, dimension);
  return (low_excluded ? value > lowest : value >= lowest) && (high_excluded ? value < highest : value <= highest);
}

}  // namespace sandsim
