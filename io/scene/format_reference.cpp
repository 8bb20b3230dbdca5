#include "io/scene/format_reference.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "io/scene/parameters.hpp"
#include "io/scene/value_text.hpp"

namespace sandsim {

namespace {

constexpr const char* introduction = R"(# The scene format

<!-- Written by `sandsim schema --reference`. Change io/scene/parameters.hpp instead. -->

A scene is one YAML document. Names of files in it are relative to its folder.

- Quantities are a number and a unit, `5 cm`. A unit is never assumed: a bare number where a unit is needed is an error,
  and so is a unit on a pure number. `cells` is the grid's spacing.
- Numbers are decimal and finite: no `010`, `0x10`, `1_000`, `.nan`. Booleans are `true` and `false`.
- Rasters are ESRI ASCII grids, known by their content, or NumPy arrays (.npy) of (y, x). An ESRI ASCII grid begins in
  the north and says where it lies. A .npy covers the grid, and its row 0 is the SOUTHERN one, at the smallest y, unless
  `first_row: north` stands beside it, also in a map `{raster: FILE, unit: deg, first_row: north}`: give it for arrays
  that were read from a GeoTIFF. `sandsim check` prints the bed in the four corners of the grid.
- Unknown keys, duplicate keys and keys that do not apply are errors. All problems of a scene are reported at once.
- `sandsim schema` prints the JSON Schema of this format; editors use it after the first line
  `# yaml-language-server: $schema=../scene.schema.json`.
- `--set key.path=value` replaces a value before the scene is read: `--set time.end=5s`,
  `--set sand.initial.0.depth=30cm` (entries of a list count from 0), `--set "sand.hbar={policy: full}"`.
  `--set key.path=` removes a key.

The units of each kind of quantity, the SI unit first:

)";

std::string without_article(const std::string& noun) {
  return noun.substr(noun.find(' ') + 1);
}

std::string units_table() {
  std::string text = "| kind | units |\n|---|---|\n";
  for (const Dimension dimension : all_dimensions) {
    text += "| " + without_article(noun(dimension)) + " | " + listed(unit_names(dimension, true)) + " |\n";
  }
  return text;
}

std::string kind_of(const Rule& rule) {
  return without_article(noun(rule.dimension));
}

/// Visitor of the table that writes one map's keys, and the maps below it after that.
class PageWriter {
 public:
  explicit PageWriter(std::string path) : path_(std::move(path)) {}

  template <class T>
  void field(const char* key, T& value, const Rule& rule, const char* meaning) {
    std::string by_default = rule.is_required && rule.instead.empty() ? "required" : default_text(value, rule);
    std::string note = meaning;
    if (!rule.instead.empty()) note += " Required without `" + rule.instead + "`.";
    if (!rule.only_with.empty()) note += " Only with `" + rule.only_with + "`.";
    rows_ += std::string("| `") + key + "` | " + type(key, value, rule) + " | " + rule.bounds_text() + " | " +
             by_default + " | " + note + " |\n";
  }

  std::string page() const {
    std::string text = table();
    for (const std::string& section : sections_) text += section;
    return text;
  }

 private:
  // ---- defaults
  // -------------------------------------------------------------------------------------------------------
  template <class T>
  static std::string default_text(const T& value, const Rule& rule) {
    if constexpr (OneLine<T>) {
      const std::string text = value_text(value, rule);
      return text == "\"\"" ? "" : '`' + text + '`';
    } else {
      return rule.is_switch ? "`false`" : "";
    }
  }

  // ---- types
  // ------------------------------------------------------------------------------------------------------------
  template <class T>
  std::string type(const std::string& key, T& value, const Rule&) {
    if constexpr (std::is_enum_v<T>) {
      std::vector<std::string> words = enum_names<T>();
      for (std::string& word : words) word = '`' + word + '`';
      return alternatives(words);
    } else {
      add_section(key, value, "");
      return "map, see [" + path_ + key + "](#" + anchor(path_ + key) + ')';
    }
  }
  std::string type(const std::string&, double&, const Rule& rule) { return kind_of(rule); }
  std::string type(const std::string&, int&, const Rule&) { return "whole number"; }
  std::string type(const std::string&, bool&, const Rule&) { return "`true` or `false`"; }
  std::string type(const std::string&, std::string&, const Rule&) { return "text"; }
  std::string type(const std::string&, RasterFile&, const Rule&) { return "file"; }
  std::string type(const std::string&, Crs&, const Rule&) { return "text"; }
  std::string type(const std::string&, PolygonFile&, const Rule&) { return "file"; }
  std::string type(const std::string&, Profile&, const Rule&) { return "file"; }
  std::string type(const std::string&, FrontCurve&, const Rule&) { return "file"; }
  std::string type(const std::string&, MeshFile&, const Rule&) { return "file"; }
  std::string type(const std::string&, SdfFile&, const Rule&) { return "file"; }
  std::string type(const std::string&, PathTable&, const Rule&) { return "file"; }
  std::string type(const std::string&, ScriptFile&, const Rule&) { return "file"; }
  std::string type(const std::string&, ScalarMap&, const Rule& rule) { return kind_of(rule) + ", or a map"; }

  template <class T>
  std::string type(const std::string& key, std::optional<T>&, const Rule& rule) {
    T value{};
    return (rule.is_switch ? "`true`, `false` or a " : "") + type(key, value, rule);
  }
  template <class T, std::size_t N>
  std::string type(const std::string& key, std::array<T, N>& values, const Rule& rule) {
    const auto first = rule.component_names.begin();
    const std::string item = type(key, values[0], rule);
    return '[' + listed({first, first + N}) + "], each " + (item.starts_with('a') ? "an " : "a ") + item;
  }
  template <class T>
  std::string type(const std::string& key, std::vector<T>&, const Rule& rule) {
    T entry{};
    const std::string item = type(key, entry, rule);
    return (rule.is_single_allowed ? "one or a list of: " : "list of: ") + item;
  }
  template <class... Ts>
  std::string type(const std::string& key, std::variant<Ts...>&, const Rule&) {
    (add_alternative<Ts>(key), ...);
    std::vector<std::string> links{link<Ts>(key)...};
    return "map with a `type`: " + alternatives(links);
  }

  // ---- sections
  // ---------------------------------------------------------------------------------------------------------
  static std::string anchor(const std::string& title) {
    std::string result;
    for (const char c : title) {
      if (c == ' ') result += '-';
      if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_') result += c;
    }
    return result;
  }

  template <class T>
  std::string link(const std::string& key) const {
    return std::string("[") + TypeName<T>::name + "](#" + anchor(path_ + key + " type " + TypeName<T>::name) + ')';
  }

  template <class T>
  void add_alternative(const std::string& key) {
    T value{};
    add_section(key, value, TypeName<T>::name, TypeName<T>::purpose);
  }

  template <class T>
  void add_section(const std::string& key, T& value, const std::string& type_name, const char* purpose = nullptr) {
    PageWriter members(path_ + key + '.');
    describe(members, value);
    std::string section = "\n## " + path_ + key + (type_name.empty() ? "" : ", type: " + type_name) + '\n';
    if (purpose != nullptr) section += '\n' + std::string(purpose) + '\n';
    append(section + members.table());
    for (const std::string& inner : members.sections_) append(inner);
  }

  /// Maps of one kind under several types, e.g. the rotations of shapes, have one section.
  void append(const std::string& section) {
    if (std::find(sections_.begin(), sections_.end(), section) == sections_.end()) sections_.push_back(section);
  }

  std::string table() const {
    return rows_.empty() ? "" : "\n| key | type | bounds | default | meaning |\n|---|---|---|---|---|\n" + rows_;
  }

  std::string path_;  // with a point at its end
  std::string rows_;
  std::vector<std::string> sections_;
};

}  // namespace

std::string format_reference() {
  Scene defaults;
  PageWriter writer("");
  describe(writer, defaults);
  return introduction + units_table() + "\n## The scene\n" + writer.page();
}

}  // namespace sandsim
