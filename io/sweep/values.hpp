// What `--vary key=VALUES` may give: lists, ranges, and intervals to draw samples from.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "io/scene/quantity.hpp"

namespace sandsim {

/// An interval that samples are drawn from. Numbers in `unit`, which is empty for pure numbers.
struct Interval {
  double first = 0.0;
  double last = 0.0;
  std::string unit;
  bool logarithmic = false;  // the logarithm is spread evenly, not the value

  /// The value at `fraction` of the way from first to last.
  double at(double fraction) const;
};

/// Values as a scene writes them, or an interval.
using SweepValues = std::variant<std::vector<std::string>, Interval>;

/// A number in a unit, to twelve significant digits: 0.3, not 0.30000000000000004.
std::string sweep_value_text(double value, const std::string& unit);

/// A value as a number and a unit ("20 deg" -> 20, "deg"; "0.5" -> 0.5, ""); nothing if it is anything else.
struct NumberWithUnit {
  double number = 0.0;
  std::string unit;
};
std::optional<NumberWithUnit> number_with_unit(std::string_view text);

/// Reads
///   20,30,40 deg      a list; a unit at its end holds for all numbers before it; [40, 1] and "a, b" are one value
///   20:40:5 deg       count values, first and last among them; also 20 deg:40 deg:5; `:log` at the end: in equal
///   ratios 20..40 deg        an interval for samples; `:log` likewise
/// The complaint names what is wrong: mixed units, empty ranges, counts.
Parsed<SweepValues> parse_sweep_values(std::string_view text);

/// The same for values that a YAML list holds, one a text.
Parsed<SweepValues> parse_sweep_list(std::vector<std::string> values);

/// Parts of `text` between `separator`s that stand outside of brackets and quotes, without spaces around them.
std::vector<std::string> split_outside_brackets(std::string_view text, char separator);

}  // namespace sandsim
