#include "io/scene/json_schema.hpp"

#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "io/scene/parameters.hpp"
#include "io/scene/value_text.hpp"

namespace sandsim {

namespace {

/// The members of a JSON object, in order; values are JSON text.
using Members = std::vector<std::pair<std::string, std::string>>;

std::string object(const Members& members) {
  std::string text;
  for (const auto& [key, value] : members) text += (text.empty() ? "" : ",") + in_quotes(key) + ':' + value;
  return '{' + text + '}';
}

std::string array(const std::vector<std::string>& values) {
  std::string text;
  for (const std::string& value : values) text += (text.empty() ? "" : ",") + value;
  return '[' + text + ']';
}

std::string array_of_texts(std::vector<std::string> words) {
  for (std::string& word : words) word = in_quotes(word);
  return array(words);
}

/// Compact JSON with one member a line; arrays of plain values stay on their line.
std::string laid_out(const std::string& compact) {
  std::string text;
  std::string indent = "\n";
  bool in_string = false;
  std::vector<bool> is_broken;
  for (std::size_t k = 0; k < compact.size(); ++k) {
    const char c = compact[k];
    if (c == '"' && (k == 0 || compact[k - 1] != '\\' || (k > 1 && compact[k - 2] == '\\'))) in_string = !in_string;
    const bool empty = k + 1 < compact.size() && (compact[k + 1] == '}' || compact[k + 1] == ']');
    if (in_string) {
      text += c;
    } else if (c == '{' || c == '[') {
      is_broken.push_back(!empty && (c == '{' || compact[k + 1] == '{'));
      text += c;
      if (is_broken.back()) text += indent += "  ";
    } else if (c == '}' || c == ']') {
      if (is_broken.back()) text += indent.erase(indent.size() - 2);
      is_broken.pop_back();
      text += c;
    } else if (c == ',') {
      text += is_broken.back() ? c + indent : ", ";
    } else {
      text += c == ':' ? ": " : std::string(1, c);
    }
  }
  return text + '\n';
}

// ---- schemas of single values
// -----------------------------------------------------------------------------------------
Members bounds(const Rule& rule) {
  Members members;
  if (rule.low > -Rule::infinity) {
    members.emplace_back(rule.low_excluded ? "exclusiveMinimum" : "minimum", shortest_text(rule.low));
  }
  if (rule.high < Rule::infinity) {
    members.emplace_back(rule.high_excluded ? "exclusiveMaximum" : "maximum", shortest_text(rule.high));
  }
  return members;
}

Members with_type(const char* type, Members members = {}) {
  members.emplace(members.begin(), "type", in_quotes(type));
  return members;
}

/// The form of "number unit".
std::string quantity_pattern(const Rule& rule) {
  std::string names;
  for (const std::string& name : unit_names(rule.dimension, rule.has_cells)) {
    names += names.empty() ? "" : "|";
    for (const char c : name) names += c == '^' ? "\\^" : std::string(1, c);
  }
  return R"(^[+-]?((0|[1-9][0-9]*)(\.[0-9]*)?|\.[0-9]+)([eE][+-]?[0-9]+)? *()" + names + ")$";
}

Members schema_of(const double&, const Rule& rule) {
  if (rule.dimension == Dimension::none) return with_type("number", bounds(rule));
  return with_type("string", {{"pattern", in_quotes(quantity_pattern(rule))}});
}
Members schema_of(const int&, const Rule& rule) {
  return with_type("integer", bounds(rule));
}
Members schema_of(const bool&, const Rule&) {
  return with_type("boolean");
}
Members schema_of(const std::string&, const Rule&) {
  return with_type("string");
}
Members schema_of(const RasterFile&, const Rule&) {
  return with_type("string");
}
Members schema_of(const Crs&, const Rule&) {
  return with_type("string");
}
Members schema_of(const PolygonFile&, const Rule&) {
  return with_type("string");
}
Members schema_of(const Profile&, const Rule&) {
  return with_type("string");
}
Members schema_of(const FrontCurve&, const Rule&) {
  return with_type("string");
}
Members schema_of(const MeshFile&, const Rule&) {
  return with_type("string");
}
Members schema_of(const SdfFile&, const Rule&) {
  return with_type("string");
}
Members schema_of(const PathTable&, const Rule&) {
  return with_type("string");
}
Members schema_of(const ScriptFile&, const Rule&) {
  return with_type("string");
}

template <class E>
requires std::is_enum_v<E> Members schema_of(const E&, const Rule&) {
  return {{"enum", array_of_texts(enum_names<E>())}};
}

Members schema_of(const ScalarMap&, const Rule& rule) {
  const std::string number = object(schema_of(double{}, rule));
  const auto map = [&](Members properties, std::vector<std::string> required) {
    if (const std::string unit = map_unit(rule.dimension); !unit.empty()) {
      properties.emplace_back("unit", object({{"const", in_quotes(unit)}}));
      required.emplace_back("unit");
    }
    return object(with_type("object", {{"properties", object(properties)},
                                       {"required", array_of_texts(required)},
                                       {"additionalProperties", "false"}}));
  };
  const std::string text = object(with_type("string"));
  Members first_row{{"description", in_quotes("Which side row 0 of a .npy file is; south if it is left out.")}};
  first_row.push_back(schema_of(FirstRow{}, rule).front());
  const Members raster{{"raster", text},
                       {"band", object(with_type("integer", {{"minimum", "1"}}))},
                       {"variable", text},
                       {"first_row", object(first_row)}};
  return {{"anyOf", array({number, map(raster, {"raster"}),
                           map({{"polygons", text}, {"layer", text}, {"attribute", text}, {"elsewhere", number}},
                               {"polygons", "attribute", "elsewhere"})})}};
}

/// The value as JSON: what YAML reads as text is in quotes.
template <class T>
std::string json_value(const T& value, const Rule& rule) {
  if constexpr (std::is_same_v<T, bool> || std::is_same_v<T, int> || std::is_same_v<T, std::string>) {
    return value_text(value, rule);
  } else if constexpr (std::is_same_v<T, double> || std::is_same_v<T, ScalarMap>) {
    return rule.dimension == Dimension::none ? value_text(value, rule) : in_quotes(value_text(value, rule));
  } else if constexpr (std::is_enum_v<T>) {
    return in_quotes(value_text(value, rule));
  } else if constexpr (requires { value.begin(); }) {
    std::vector<std::string> values;
    for (const auto& item : value) values.push_back(json_value(item, rule));
    return array(values);
  } else {
    return {};
  }
}

// ---- schemas of maps and lists
// ----------------------------------------------------------------------------------------
/// Visitor of the table that describes the keys of a map.
class SchemaWriter {
 public:
  template <class T>
  void field(const char* key, T& value, const Rule& rule, const char* meaning) {
    std::string description = meaning;
    if (!rule.only_with.empty()) description += " Only with " + rule.only_with + '.';
    if (!rule.instead.empty()) description += " Required without " + rule.instead + '.';
    if (rule.dimension != Dimension::none && !rule.bounds_text().empty()) {
      description += " Valid: " + rule.bounds_text() + '.';
    }
    Members members{{"description", in_quotes(description)}};
    for (auto& member : schema(value, rule)) members.push_back(std::move(member));
    if constexpr (OneLine<T>) {
      if (std::string text = json_value(value, rule); !rule.is_required && !text.empty()) {
        members.emplace_back("default", std::move(text));
      }
    }
    if (rule.is_switch) members.emplace_back("default", "false");
    if (rule.is_required && rule.only_with.empty() && rule.instead.empty()) required_.emplace_back(key);
    properties_.emplace_back(key, object(members));
  }

  void add_type(const char* name) {
    properties_.emplace_back("type", object({{"const", in_quotes(name)}}));
    required_.emplace_back("type");
  }

  Members finish() const {
    Members members = with_type("object", {{"properties", object(properties_)}});
    if (!required_.empty()) members.emplace_back("required", array_of_texts(required_));
    members.emplace_back("additionalProperties", "false");
    return members;
  }

 private:
  template <class T>
  Members schema(T& value, const Rule& rule) {
    if constexpr (requires { schema_of(value, rule); }) {
      return schema_of(value, rule);
    } else {
      SchemaWriter members;
      describe(members, value);
      return members.finish();
    }
  }
  Members schema(ScalarMap& value, const Rule& rule) { return schema_of(value, rule); }

  template <class T>
  Members schema(std::optional<T>&, const Rule& rule) {
    T value{};
    if (!rule.is_switch) return schema(value, rule);
    return {{"anyOf", array({object(with_type("boolean")), object(schema(value, rule))})}};
  }

  template <class T, std::size_t N>
  Members schema(std::array<T, N>& values, const Rule& rule) {
    const std::string count = std::to_string(N);
    return with_type("array", {{"items", object(schema(values[0], rule))}, {"minItems", count}, {"maxItems", count}});
  }

  template <class T>
  Members schema(std::vector<T>&, const Rule& rule) {
    T entry{};
    const std::string item = object(schema(entry, rule));
    Members list = with_type("array", {{"items", item}});
    if (!rule.is_empty_allowed) list.emplace_back("minItems", "1");
    if (!rule.is_single_allowed) return list;
    return {{"anyOf", array({item, object(list)})}};
  }

  template <class... Ts>
  Members schema(std::variant<Ts...>&, const Rule&) {
    return {{"oneOf", array({alternative<Ts>()...})}};
  }

  template <class T>
  static std::string alternative() {
    T value{};
    SchemaWriter members;
    members.add_type(TypeName<T>::name);
    describe(members, value);
    Members schema{{"description", in_quotes(TypeName<T>::purpose)}};
    for (auto& member : members.finish()) schema.push_back(std::move(member));
    return object(schema);
  }

  Members properties_;
  std::vector<std::string> required_;
};

}  // namespace

std::string json_schema() {
  Scene defaults;
  SchemaWriter writer;
  describe(writer, defaults);
  Members schema{{"$schema", in_quotes("http://json-schema.org/draft-07/schema#")},
                 {"title", in_quotes("sandsim scene")}};
  for (auto& member : writer.finish()) schema.push_back(std::move(member));
  return laid_out(object(schema));
}

}  // namespace sandsim
