// What a value of the scene has to satisfy: one row of the parameter table.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "io/scene/quantity.hpp"

namespace sandsim {

/// Built up by chained calls: length().above(0).required().
struct Rule {
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  Dimension dimension = Dimension::none;
  double low = -infinity;  // bounds in the SI unit, of angles in degrees
  double high = infinity;
  bool low_excluded = false;
  bool high_excluded = false;
  bool is_required = false;
  bool has_cells = true;                                    // lengths in "cells" are allowed
  bool is_single_allowed = false;                           // lists: one entry may stand for the list
  bool is_empty_allowed = true;                             // lists
  bool is_switch = false;                                   // sections: true and false may stand for them
  bool may_be_missing = false;                              // files: missing is a warning
  bool applies = true;                                      // false: giving the key is an error
  std::string only_with;                                    // "mode: fixed": when it applies
  std::string instead;                                      // the key that may stand in for a required one
  std::vector<std::string> component_names{"x", "y", "z"};  // arrays: what their values are, in their order
  std::string example_text;

  Rule at_least(double bound) const {
    return with([&](Rule& r) { r.low = bound; });
  }
  Rule at_most(double bound) const {
    return with([&](Rule& r) { r.high = bound; });
  }
  Rule above(double bound) const {
    return with([&](Rule& r) { r.low = bound, r.low_excluded = true; });
  }
  Rule below(double bound) const {
    return with([&](Rule& r) { r.high = bound, r.high_excluded = true; });
  }
  Rule required() const {
    return with([](Rule& r) { r.is_required = true; });
  }
  /// Required where another key of the map, `other`, is not given.
  Rule required_unless(bool is_given, std::string other) const {
    return with([&](Rule& r) { r.is_required = !is_given, r.instead = other; });
  }
  Rule without_cells() const {
    return with([](Rule& r) { r.has_cells = false; });
  }
  Rule single_allowed() const {
    return with([](Rule& r) { r.is_single_allowed = true; });
  }
  Rule not_empty() const {
    return with([](Rule& r) { r.is_empty_allowed = false; });
  }
  /// A section that is off without its key: `true` stands for its defaults, `false` for off.
  Rule or_switch() const {
    return with([](Rule& r) { r.is_switch = true; });
  }
  Rule optional_file() const {
    return with([](Rule& r) { r.may_be_missing = true; });
  }
  /// The key belongs to one value of a key read before, e.g. only(time.mode == TimeMode::fixed, "mode: fixed").
  Rule only(bool condition, std::string when) const {
    return with([&](Rule& r) { r.applies = condition, r.only_with = when; });
  }
  Rule components(std::vector<std::string> names) const {
    return with([&](Rule& r) { r.component_names = names; });
  }
  Rule like(std::string text) const {
    return with([&](Rule& r) { r.example_text = text; });
  }

  /// The bounds in words, "at least 0 and below 89 deg"; empty without any.
  std::string bounds_text() const;
  /// `value` in SI units lies within the bounds.
  bool holds(double value) const;
  std::string example() const { return example_text.empty() ? sandsim::example(dimension) : example_text; }

 private:
  template <class Change>
  Rule with(Change change) const {
    Rule copy = *this;
    change(copy);
    return copy;
  }
};

inline Rule quantity(Dimension dimension) {
  Rule rule;
  rule.dimension = dimension;
  return rule;
}
inline Rule number() {
  return {};
}
inline Rule text() {
  return {};
}
inline Rule choice() {
  return {};
}
inline Rule section() {
  return {};
}
inline Rule list() {
  return {};
}
inline Rule file() {
  return {};
}
inline Rule length() {
  return quantity(Dimension::length);
}
inline Rule angle() {
  return quantity(Dimension::angle);
}
inline Rule time_span() {
  return quantity(Dimension::time);
}
inline Rule speed() {
  return quantity(Dimension::speed);
}
inline Rule angular_velocity() {
  return quantity(Dimension::angular_velocity);
}
inline Rule acceleration() {
  return quantity(Dimension::acceleration);
}
inline Rule volume_rate() {
  return quantity(Dimension::volume_rate);
}
inline Rule density() {
  return quantity(Dimension::density);
}

}  // namespace sandsim
