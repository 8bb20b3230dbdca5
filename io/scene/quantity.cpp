#include "io/scene/quantity.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>

namespace sandsim {

namespace {

constexpr std::array<Unit, 4> lengths{{{"m", 1, 1}, {"cm", 1, 100}, {"mm", 1, 1000}, {"km", 1000, 1}}};
constexpr std::array<Unit, 2> angles{{{"rad", 1, 1}, {"deg", std::numbers::pi, 180}}};
constexpr std::array<Unit, 4> times{{{"s", 1, 1}, {"ms", 1, 1000}, {"min", 60, 1}, {"h", 3600, 1}}};
constexpr std::array<Unit, 4> speeds{{{"m/s", 1, 1}, {"cm/s", 1, 100}, {"mm/s", 1, 1000}, {"km/h", 1000, 3600}}};
constexpr std::array<Unit, 3> angular_velocities{
    {{"rad/s", 1, 1}, {"deg/s", std::numbers::pi, 180}, {"rpm", std::numbers::pi, 30}}};
constexpr std::array<Unit, 2> accelerations{{{"m/s^2", 1, 1}, {"cm/s^2", 1, 100}}};
constexpr std::array<Unit, 3> volume_rates{{{"m^3/s", 1, 1}, {"l/s", 1, 1000}, {"cm^3/s", 1, 1'000'000}}};
constexpr std::array<Unit, 3> densities{{{"kg/m^3", 1, 1}, {"g/cm^3", 1000, 1}, {"t/m^3", 1000, 1}}};

bool digit(char c) {
  return c >= '0' && c <= '9';
}

/// The length of the number that `text` starts with; 0 if it starts with none.
std::size_t number_length(std::string_view text) {
  std::size_t k = !text.empty() && (text[0] == '+' || text[0] == '-') ? 1 : 0;
  const std::size_t sign = k;
  while (k < text.size() && digit(text[k])) ++k;
  std::size_t digits = k - sign;
  if (k < text.size() && text[k] == '.') {
    const std::size_t point = k++;
    while (k < text.size() && digit(text[k])) ++k;
    digits += k - point - 1;
  }
  if (digits == 0) return 0;
  if (k < text.size() && (text[k] == 'e' || text[k] == 'E')) {
    std::size_t e = k + 1;
    if (e < text.size() && (text[e] == '+' || text[e] == '-')) ++e;
    if (e < text.size() && digit(text[e])) {
      while (e < text.size() && digit(text[e])) ++e;
      k = e;
    }
  }
  return k;
}

/// A number and the text after it.
struct Leading {
  double value = 0.0;
  std::string_view rest;
};

Complaint not_a_number(std::string_view text) {
  std::string lower;
  for (const char c : text) lower += static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  for (const char* word : {".nan", ".inf", "-.inf", "+.inf", "nan", "inf", "-inf", "+inf", "infinity"}) {
    if (lower == word) return {"not a finite number", "every value of a scene is finite", ""};
  }
  return {"not a number", "", ""};
}

Parsed<Leading> leading_number(std::string_view text) {
  const std::size_t length = number_length(text);
  if (length == 0) return not_a_number(text);
  std::string_view number = text.substr(0, length);
  Leading result{0.0, text.substr(length)};
  if (result.rest.starts_with('x') || result.rest.starts_with('X')) {
    return Complaint{"not a decimal number", "hexadecimal is not used in scenes", ""};
  }
  if (result.rest.starts_with('_') || (result.rest.starts_with(','))) {
    return Complaint{"not a number", "digits are not grouped, and the decimal mark is a point", ""};
  }
  if (number[0] == '+') number.remove_prefix(1);
  const std::size_t first = number[0] == '-' ? 1 : 0;
  if (number.size() > first + 1 && number[first] == '0' && digit(number[first + 1])) {
    return Complaint{"a number with a leading zero", "some programs read it as octal", "Write it without the zero."};
  }
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), result.value);
  if (error != std::errc{} || end != number.data() + number.size() || !std::isfinite(result.value)) {
    return Complaint{"a number that double precision cannot hold", "its magnitude is outside 1e-307 to 1e308", ""};
  }
  return result;
}

std::string_view without_spaces(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

/// The dimension that a unit belongs to.
std::optional<Dimension> dimension_of(std::string_view unit) {
  for (const Dimension dimension : all_dimensions) {
    for (const Unit& candidate : units(dimension)) {
      if (unit == candidate.name) return dimension;
    }
  }
  if (unit == "cells") return Dimension::length;
  return std::nullopt;
}

Complaint wrong_unit(std::string_view unit, Dimension dimension, bool with_cells) {
  const std::vector<std::string> names = unit_names(dimension, with_cells);
  const std::string valid = "Units of " + std::string(noun(dimension)) + ": " + alternatives(names) + '.';
  if (unit == "cells" && dimension == Dimension::length) {
    return {"'cells' cannot be used here", "it is this value that says how long a cell is", valid};
  }
  if (const std::optional<Dimension> other = dimension_of(unit)) {
    return {"'" + std::string(unit) + "' is no unit of " + noun(dimension),
            "it is a unit of " + std::string(noun(*other)), valid};
  }
  const std::string near = nearest(unit, names);
  return {"unknown unit '" + shown(unit, 20) + "'", "", (near.empty() ? "" : "Did you mean '" + near + "'? ") + valid};
}

}  // namespace

std::span<const Unit> units(Dimension dimension) {
  switch (dimension) {
    case Dimension::length:
      return lengths;
    case Dimension::angle:
      return angles;
    case Dimension::time:
      return times;
    case Dimension::speed:
      return speeds;
    case Dimension::angular_velocity:
      return angular_velocities;
    case Dimension::acceleration:
      return accelerations;
    case Dimension::volume_rate:
      return volume_rates;
    case Dimension::density:
      return densities;
    case Dimension::none:
      break;
  }
  return {};
}

const char* noun(Dimension dimension) {
  switch (dimension) {
    case Dimension::length:
      return "a length";
    case Dimension::angle:
      return "an angle";
    case Dimension::time:
      return "a time";
    case Dimension::speed:
      return "a speed";
    case Dimension::angular_velocity:
      return "an angular velocity";
    case Dimension::acceleration:
      return "an acceleration";
    case Dimension::volume_rate:
      return "a volume per time";
    case Dimension::density:
      return "a density";
    case Dimension::none:
      break;
  }
  return "a number";
}

const char* example(Dimension dimension) {
  switch (dimension) {
    case Dimension::length:
      return "20 cm";
    case Dimension::angle:
      return "30 deg";
    case Dimension::time:
      return "20 ms";
    case Dimension::speed:
      return "30 cm/s";
    case Dimension::angular_velocity:
      return "90 deg/s";
    case Dimension::acceleration:
      return "9.8 m/s^2";
    case Dimension::volume_rate:
      return "2 l/s";
    case Dimension::density:
      return "1500 kg/m^3";
    case Dimension::none:
      break;
  }
  return "0.5";
}

std::vector<std::string> unit_names(Dimension dimension, bool with_cells) {
  std::vector<std::string> names;
  for (const Unit& unit : units(dimension)) names.emplace_back(unit.name);
  if (dimension == Dimension::length && with_cells) names.emplace_back("cells");
  return names;
}

Parsed<double> parse_plain_number(std::string_view text) {
  const Parsed<Leading> parsed = leading_number(text);
  if (const Complaint* complaint = std::get_if<Complaint>(&parsed)) return *complaint;
  const Leading& number = std::get<Leading>(parsed);
  const std::string_view rest = without_spaces(number.rest);
  if (rest.empty()) return number.value;
  if (dimension_of(rest)) {
    const std::string bare(text.substr(0, text.size() - number.rest.size()));
    return Complaint{"a number without a unit is needed", "", "Did you mean " + bare + "?"};
  }
  return Complaint{"not a number", "", ""};
}

Parsed<int> parse_count(std::string_view text) {
  const Parsed<double> parsed = parse_plain_number(text);
  if (const Complaint* complaint = std::get_if<Complaint>(&parsed)) return *complaint;
  if (text.starts_with('+')) text.remove_prefix(1);
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::result_out_of_range) return Complaint{"too large", "at most 2147483647", ""};
  if (error != std::errc{} || end != text.data() + text.size()) {
    return Complaint{"a whole number is needed", "written with digits only", ""};
  }
  return value;
}

Parsed<double> parse_quantity(std::string_view text, Dimension dimension, double cell, std::string_view sample) {
  if (dimension == Dimension::none) return parse_plain_number(text);
  Parsed<Leading> parsed = leading_number(text);
  if (Complaint* complaint = std::get_if<Complaint>(&parsed)) {
    if (complaint->suggestion.empty()) {
      complaint->suggestion = "Write " + std::string(noun(dimension)) + " like \"" + std::string(sample) + "\".";
    }
    return *complaint;
  }
  const Leading& number = std::get<Leading>(parsed);
  const std::string_view unit = without_spaces(number.rest);
  if (unit.empty()) {
    return Complaint{
        std::string(noun(dimension)) + " needs a unit", "no unit is assumed",
        "Did you mean \"" + std::string(without_spaces(text)) + std::string(sample.substr(sample.find(' '))) + "\"?"};
  }
  double value = 0.0;
  if (unit == "cells" && cell > 0.0 && dimension == Dimension::length) {
    value = number.value * cell;
  } else {
    const Unit* found = nullptr;
    for (const Unit& candidate : units(dimension)) {
      if (unit == candidate.name) found = &candidate;
    }
    if (found == nullptr) return wrong_unit(unit, dimension, cell > 0.0);
    value = number.value * found->numerator / found->denominator;
  }
  if (!std::isfinite(value)) return Complaint{"not finite in SI units", "every value of a scene is finite", ""};
  return value;
}

std::string shortest_text(double value) {
  std::array<char, 32> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), result.ptr};
}

std::string quantity_text(double value, Dimension dimension) {
  const std::span<const Unit> known = units(dimension);
  return known.empty() ? shortest_text(value) : shortest_text(value) + ' ' + known.front().name;
}

}  // namespace sandsim
