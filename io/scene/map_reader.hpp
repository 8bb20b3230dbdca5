// The reading of a map into a struct, as a table of parameters describes it.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "io/scene/node.hpp"
#include "io/scene/reading.hpp"
#include "io/scene/rule.hpp"
#include "io/scene/type_name.hpp"
#include "solver/grid_like.hpp"

namespace sandsim {

/// A key that is no more, and what to write in its place.
struct ReplacedKey {
  const char* path;
  const char* instead;
};
inline constexpr std::array replaced_keys{ReplacedKey{"output.arrival_depth", "output.maxima: {above: 10 cm}"}};

/// Visitor of a table of parameters that fills a struct from a map. Types that are neither known to Reading nor
/// described by a table bring a function parse_member(reading, node, path, target).
class MapReader {
 public:
  MapReader(Reading& reading, const Node& map, std::string path)
      : reading_(reading), map_(map), path_(std::move(path)) {}

  template <class T>
  void field(const char* key, T& target, const Rule& rule, const char* meaning) {
    keys_.emplace_back(key);
    const std::string path = path_of(key);
    const Node* node = map_.find(key);
    if (node != nullptr) reading_.note(path, *node);
    // A key that hangs on a wrong one is neither missing nor unused.
    const bool decided =
        rule.only_with.empty() || !reading_.failed(path_of(rule.only_with.substr(0, rule.only_with.find(':'))));
    if (!decided) return;
    if (node == nullptr) {
      if (rule.is_required && rule.applies) report_missing(key, rule, meaning);
    } else if (!rule.applies) {
      reading_.complain(*node, path, {"not used", "it belongs to " + rule.only_with, "Remove it."});
    } else if (node->kind == Node::Kind::null) {
      reading_.complain_key(node->position, path, {"no value", "the key is there, but nothing after it", ""});
    } else {
      read(*node, path, target, rule);
    }
  }

  /// A key that is not in the table, e.g. the type of a part.
  void know(const char* key) { keys_.emplace_back(key); }

  /// The grid of a raster in place of one in numbers; from here on lengths may be in cells.
  void take_grid(Grid& grid, const GridLike& from) {
    if (from.like && !reading_.failed(path_)) {
      auto found = grid_of(from, grid.spacing);
      if (const auto* issue = std::get_if<Issue>(&found)) {
        reading_.complain_at(issue->key, {issue->problem, issue->why, issue->suggestion});
        return;
      }
      grid = std::move(std::get<Grid>(found));
    }
    reading_.know_grid(grid);
  }

  /// Complains about keys that no field has asked for.
  void finish() const {
    for (const Node& child : map_.children) {
      if (std::find(keys_.begin(), keys_.end(), child.key) != keys_.end()) continue;
      reading_.complain_key(child.position, path_of(child.key), unknown_key(child.key));
    }
  }

 private:
  Complaint unknown_key(const std::string& key) const {
    for (const ReplacedKey& replaced : replaced_keys) {
      if (path_of(key) == replaced.path) {
        return {"no key any more", "", std::string("Write ") + replaced.instead + " instead."};
      }
    }
    const std::string near = nearest(key, keys_);
    return {"unknown key", "",
            (near.empty() ? "" : "Did you mean '" + near + "'? ") + "Valid keys: " + listed(keys_) + '.'};
  }

  std::string path_of(const std::string& key) const { return path_.empty() ? key : path_ + '.' + key; }

  void report_missing(const std::string& key, const Rule& rule, const char* meaning) {
    const Position position = path_.empty() ? Position{1, 1, -1} : map_.position;
    std::string why = meaning;
    if (why.ends_with('.')) why.pop_back();
    reading_.complain_key(position, path_of(key), {"missing", why, "Add \"" + key + ": " + rule.example() + "\"."});
  }

  // One overload for each kind of member. What Reading knows goes to it; the rest is taken apart here.
  template <class T>
  void read(const Node& node, const std::string& path, T& target, const Rule& rule) {
    if constexpr (std::is_enum_v<T>) {
      const std::size_t index = reading_.parse_name(node, path, enum_names<T>());
      if (index != Reading::npos) target = static_cast<T>(index);
    } else if constexpr (requires { reading_.parse(node, path, target, rule); }) {
      reading_.parse(node, path, target, rule);
    } else if constexpr (requires { parse_member(reading_, node, path, target); }) {
      parse_member(reading_, node, path, target);
    } else if (reading_.expect(node, path, Node::Kind::map, rule.example_text)) {
      MapReader members(reading_, node, path);
      describe(members, target);
      members.finish();
    }
  }

  template <class T>
  void read(const Node& node, const std::string& path, std::optional<T>& target, const Rule& rule) {
    T value{};
    const bool is_word = rule.is_switch && node.kind == Node::Kind::scalar;
    if (!is_word) {
      read(node, path, value, rule);
    } else if (node.quoted || (node.text != "true" && node.text != "false")) {
      reading_.complain(node, path, {"true, false or a map is needed", "", "Write it like " + rule.example() + "."});
    }
    target = is_word && node.text != "true" ? std::nullopt : std::optional(std::move(value));
  }

  template <class T, std::size_t N>
  void read(const Node& node, const std::string& path, std::array<T, N>& target, const Rule& rule) {
    if (!reading_.expect(node, path, Node::Kind::list, rule.example())) return;
    if (node.children.size() != N) {
      constexpr std::array counts{"two", "three", "four"};
      const auto first = rule.component_names.begin();
      reading_.complain(
          node, path,
          {std::string(counts.at(N - 2)) + " values are needed, " + together({first, first + N}),
           "these are " + std::to_string(node.children.size()), "Write them like " + rule.example() + "."});
      return;
    }
    for (std::size_t k = 0; k < N; ++k) read_item(node.children[k], path, k, target[k], rule);
  }

  template <class T>
  void read(const Node& node, const std::string& path, std::vector<T>& target, const Rule& rule) {
    target.clear();
    if (node.kind != Node::Kind::list) {
      if (!rule.is_single_allowed) {
        reading_.expect(node, path, Node::Kind::list, "");
        return;
      }
      reading_.note_single(path);
      target.resize(1);
      read_item(node, path, 0, target[0], rule);
      return;
    }
    if (node.children.empty() && !rule.is_empty_allowed) {
      reading_.complain(node, path, {"the list is empty", "at least one entry is needed", ""});
    }
    target.resize(node.children.size());
    for (std::size_t k = 0; k < target.size(); ++k) read_item(node.children[k], path, k, target[k], rule);
  }

  template <class T>
  void read_item(const Node& node, const std::string& path, std::size_t index, T& target, const Rule& rule) {
    const std::string item = path + '.' + std::to_string(index);
    reading_.note(item, node);
    // The example of a list is no example of its entries.
    Rule entry = rule;
    entry.example_text.clear();
    read(node, item, target, entry);
  }

  template <class... Ts>
  void read(const Node& node, const std::string& path, std::variant<Ts...>& target, const Rule&) {
    const std::vector<std::string> names{TypeName<Ts>::name...};
    if (!reading_.expect(node, path, Node::Kind::map, "{type: " + names.front() + ", ...}")) return;
    const Node* type = node.find("type");
    if (type == nullptr) {
      reading_.complain_key(node.position, path + ".type", {"missing", "", "Valid: " + alternatives(names) + '.'});
      return;
    }
    reading_.note(path + ".type", *type);
    const std::size_t index = reading_.parse_name(*type, path + ".type", names);
    (read_alternative<Ts>(node, path, target, index != Reading::npos && names[index] == TypeName<Ts>::name), ...);
  }

  template <class T, class Variant>
  void read_alternative(const Node& node, const std::string& path, Variant& target, bool chosen) {
    if (!chosen) return;
    MapReader members(reading_, node, path);
    members.know("type");
    T& part = target.template emplace<T>();
    describe(members, part);
    members.finish();
    if constexpr (requires { part.place; }) part.place = reading_.place_of(node);
  }

  // ScalarMap is a variant, but a value to the reader.
  void read(const Node& node, const std::string& path, ScalarMap& target, const Rule& rule) {
    reading_.parse(node, path, target, rule);
  }

  Reading& reading_;
  const Node& map_;
  std::string path_;
  std::vector<std::string> keys_;
};

}  // namespace sandsim
