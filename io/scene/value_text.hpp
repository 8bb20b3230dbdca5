// Values of a scene as a scene file writes them: in SI units, reading back to the same bits.
#pragma once

#include <array>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "io/scene/names.hpp"
#include "io/scene/rule.hpp"
#include "solver/scene.hpp"

namespace sandsim {

/// Text in double quotes, escaped as YAML and JSON both read it.
std::string in_quotes(const std::string& text);

/// The unit that has to be stated beside the file of a map of this dimension; empty for pure numbers.
const char* map_unit(Dimension dimension);

inline std::string value_text(double value, const Rule& rule) {
  return quantity_text(value, rule.dimension);
}
inline std::string value_text(int value, const Rule&) {
  return std::to_string(value);
}
inline std::string value_text(bool value, const Rule&) {
  return value ? "true" : "false";
}
inline std::string value_text(const std::string& value, const Rule&) {
  return in_quotes(value);
}
inline std::string value_text(const RasterFile& value, const Rule&) {
  return in_quotes(value.file);
}
inline std::string value_text(const Crs& value, const Rule&) {
  return in_quotes(value.name);
}
inline std::string value_text(const PolygonFile& value, const Rule&) {
  return in_quotes(value.file);
}
inline std::string value_text(const Profile& value, const Rule&) {
  return in_quotes(value.file);
}
inline std::string value_text(const FrontCurve& value, const Rule&) {
  return in_quotes(value.file);
}
inline std::string value_text(const MeshFile& value, const Rule&) {
  return in_quotes(value.file);
}
inline std::string value_text(const SdfFile& value, const Rule&) {
  return in_quotes(value.file);
}
inline std::string value_text(const PathTable& value, const Rule&) {
  return in_quotes(value.file);
}
inline std::string value_text(const ScriptFile& value, const Rule&) {
  return in_quotes(value.file);
}
std::string value_text(const ScalarMap& value, const Rule& rule);

template <class E>
requires std::is_enum_v<E> std::string value_text(E value, const Rule&) {
  return enum_name(value);
}

/// A list in brackets on one line.
template <class List>
std::string list_text(const List& values, const Rule& rule) {
  std::string text;
  for (const auto& value : values) text += (text.empty() ? "" : ", ") + value_text(value, rule);
  return '[' + text + ']';
}
template <class T, std::size_t N>
std::string value_text(const std::array<T, N>& values, const Rule& rule) {
  return list_text(values, rule);
}
template <class T>
requires requires(const T& value, const Rule& rule) {
  value_text(value, rule);
}
std::string value_text(const std::vector<T>& values, const Rule& rule) {
  return list_text(values, rule);
}

/// True for members that value_text writes on one line; the others are maps, or lists of maps.
template <class T>
concept OneLine = requires(const T& value, const Rule& rule) {
  value_text(value, rule);
};

}  // namespace sandsim
