// The writing of a struct as a map, as a table of parameters describes it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "io/scene/value_text.hpp"

namespace sandsim {

/// Visitor of a table of parameters that writes a struct as a block map.
class MapWriter {
 public:
  MapWriter(std::string indent, const std::filesystem::path& directory)
      : indent_(std::move(indent)), directory_(directory) {}

  template <class T>
  void field(const char* key, T& value, const Rule& rule, const char*) {
    if (rule.applies) write(key, value, rule);
  }

  /// The lines of the map, each with its indent and its line end.
  const std::string& lines() const { return lines_; }

  void add_line(const std::string& text) { lines_ += indent_ + text + '\n'; }

 private:
  template <class T>
  void write(const std::string& key, T& value, const Rule& rule) {
    if constexpr (requires { value.known(); }) {
      if (!value.known()) return;
    }
    if constexpr (OneLine<T>) {
      add_line(key + ": " + value_text(located(value), rule));
    } else {
      MapWriter members(indent_ + "  ", directory_);
      members.write_members(value);
      append(key, members.lines(), "{}");
    }
  }

  template <class T>
  void write(const std::string& key, std::optional<T>& value, const Rule& rule) {
    if (value) {
      write(key, *value, rule);
    } else if (rule.is_switch) {
      add_line(key + ": false");
    }
  }

  template <class T>
  requires(!OneLine<T>) void write(const std::string& key, std::vector<T>& values, const Rule&) {
    std::string items;
    for (T& value : values) {
      MapWriter members(indent_ + "    ", directory_);
      members.write_members(value);
      std::string item = members.lines();
      // The first line of an entry carries its dash.
      item[indent_.size() + 2] = '-';
      items += item;
    }
    append(key, items, "[]");
  }

  template <class T>
  void write_members(T& value) {
    describe(*this, value);
  }
  template <class... Ts>
  void write_members(std::variant<Ts...>& value) {
    std::visit(
        [&]<class T>(T& alternative) {
          add_line(std::string("type: ") + TypeName<T>::name);
          describe(*this, alternative);
        },
        value);
  }

  void append(const std::string& key, const std::string& inner, const char* if_empty) {
    if (inner.empty()) {
      add_line(key + ": " + if_empty);
    } else {
      add_line(key + ':');
      lines_ += inner;
    }
  }

  // File names are moved into the directory; everything else is written as it is.
  template <class T>
  const T& located(const T& value) const {
    return value;
  }
  std::string moved(const std::string& file) const {
    return directory_.empty() ? file : (directory_ / file).lexically_normal().string();
  }
  RasterFile located(RasterFile value) const {
    value.file = moved(value.file);
    return value;
  }
  PolygonFile located(PolygonFile value) const {
    value.file = moved(value.file);
    return value;
  }
  Profile located(const Profile& value) const { return {moved(value.file), {}, {}}; }
  FrontCurve located(const FrontCurve& value) const { return {moved(value.file), {}, {}}; }
  MeshFile located(const MeshFile& value) const { return {moved(value.file), value.mesh, value.distance}; }
  SdfFile located(const SdfFile& value) const { return {moved(value.file), value.distance}; }
  PathTable located(const PathTable& value) const { return {moved(value.file), {}, {}}; }
  ScriptFile located(const ScriptFile& value) const { return {moved(value.file)}; }
  ScalarMap located(const ScalarMap& value) const {
    if (const auto* file = std::get_if<RasterFile>(&value)) return located(*file);
    const auto* zones = std::get_if<ZoneMap>(&value);
    return zones == nullptr ? value : ZoneMap{located(zones->polygons), zones->elsewhere};
  }

  std::string indent_;
  const std::filesystem::path& directory_;
  std::string lines_;
};

}  // namespace sandsim
