// Numbers with units: "5 cm", "30 deg". Strict: one way to write a number, and no unit is ever assumed.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "io/scene/problems.hpp"

namespace sandsim {

enum class Dimension { none, length, angle, time, speed, angular_velocity, acceleration, volume_rate, density };
/// All but `none`, in the order in which they are documented.
inline constexpr std::array all_dimensions{
    Dimension::length,           Dimension::angle,        Dimension::time,        Dimension::speed,
    Dimension::angular_velocity, Dimension::acceleration, Dimension::volume_rate, Dimension::density};

/// One unit is numerator/denominator of the SI unit. Dividing keeps "7 cm" the double nearest to 0.07.
struct Unit {
  const char* name;
  double numerator;
  double denominator;
};

/// The units a scene may use, the SI unit first. "cells" (lengths) is not among them.
std::span<const Unit> units(Dimension dimension);
/// "a length".
const char* noun(Dimension dimension);
/// "20 cm": what a value of the dimension may look like.
const char* example(Dimension dimension);
/// The units' names; with_cells adds "cells" to lengths.
std::vector<std::string> unit_names(Dimension dimension, bool with_cells);

/// A number, or what is wrong with it.
template <class T>
using Parsed = std::variant<T, Complaint>;

/// `text` as a number without a unit. Rejects 010, 0x10, 1_000, 1,5, .nan, .inf and what double cannot hold.
Parsed<double> parse_plain_number(std::string_view text);
Parsed<int> parse_count(std::string_view text);

/// `text` ("5 cm") in SI units. `cell` is the grid's spacing [m] for lengths in cells, 0 where these are not allowed.
/// `sample` is a value as it may look like; a bare number is suggested to be in its unit.
Parsed<double> parse_quantity(std::string_view text, Dimension dimension, double cell, std::string_view sample);

/// The shortest text that reads back to the same bits.
std::string shortest_text(double value);
/// In SI units, e.g. "0.05 m"; a plain number for Dimension::none.
std::string quantity_text(double value, Dimension dimension);

}  // namespace sandsim
