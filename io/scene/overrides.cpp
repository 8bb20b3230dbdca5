#include "io/scene/overrides.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "io/scene/yaml_tree.hpp"

namespace sandsim {

namespace {

std::vector<std::string> split(const std::string& path) {
  std::vector<std::string> words;
  std::size_t start = 0;
  for (std::size_t dot = path.find('.'); dot != std::string::npos; dot = path.find('.', start)) {
    words.push_back(path.substr(start, dot - start));
    start = dot + 1;
  }
  words.push_back(path.substr(start));
  return words;
}

std::optional<std::size_t> list_index(const std::string& word) {
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), index);
  if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
  return index;
}

/// The child `word` of `node`, made if it is not there. Complains by returning what is wrong.
std::variant<Node*, Complaint> descend(Node& node, const std::string& word, const Position& position) {
  const std::optional<std::size_t> index = list_index(word);
  if (node.kind == Node::Kind::list) {
    const std::string size = std::to_string(node.children.size());
    if (!index)
      return Complaint{"'" + shown(word) + "' is no index", "it counts the " + size + " entries of a list from 0", ""};
    if (*index > node.children.size())
      return Complaint{"no entry " + word, "the list has " + size + ", counted from 0", ""};
    if (*index == node.children.size()) {
      node.children.emplace_back();
      node.children.back().position = position;
    }
    return &node.children[*index];
  }
  if (Node* child = node.find(word)) return child;
  if (node.kind == Node::Kind::map && index == std::size_t{0}) return &node;
  if (node.kind == Node::Kind::scalar) {
    return Complaint{"'" + shown(word) + "' lies inside a value", "'" + shown(node) + "' is no map", ""};
  }
  node.kind = Node::Kind::map;
  Node child;
  child.key = word;
  child.position = position;
  node.children.push_back(std::move(child));
  return &node.children.back();
}

void remove(Node& parent, const std::string& word, const Position& position, Problems& problems) {
  const std::optional<std::size_t> index = list_index(word);
  const auto found = std::find_if(parent.children.begin(), parent.children.end(), [&](const Node& child) {
    return parent.kind == Node::Kind::list ? index == static_cast<std::size_t>(&child - parent.children.data())
                                           : child.key == word;
  });
  if (found == parent.children.end()) {
    problems.add(position, "", {"nothing to remove", "the scene does not give this key", ""});
  } else {
    parent.children.erase(found);
  }
}

void apply(Node& root, const std::string& text, int at, Problems& problems) {
  const Position position{0, 0, at};
  const std::size_t equals = text.find('=');
  const std::vector<std::string> words = split(text.substr(0, equals));
  const bool has_empty_word = std::any_of(words.begin(), words.end(), [](const auto& word) { return word.empty(); });
  if (equals == std::string::npos || has_empty_word || words.size() > 64) {
    problems.add(position, "", {"not of the form key.path=value", "", "Write it like --set time.end=5s."});
    return;
  }
  Node value = parse_yaml(text.substr(equals + 1), problems, at);
  const bool removes = equals + 1 == text.size();
  Node* node = &root;
  for (std::size_t k = 0; k + (removes ? 1 : 0) < words.size(); ++k) {
    const auto child = descend(*node, words[k], position);
    if (const Complaint* complaint = std::get_if<Complaint>(&child)) {
      problems.add(position, "", *complaint);
      return;
    }
    node = std::get<Node*>(child);
  }
  if (removes) {
    remove(*node, words.back(), position, problems);
    return;
  }
  value.key = node->key;
  value.position = position;
  *node = std::move(value);
}

}  // namespace

std::vector<Override> command_line_overrides(std::span<const std::string> texts) {
  std::vector<Override> overrides;
  for (const std::string& text : texts) overrides.push_back({text, "--set " + shown(text, 200)});
  return overrides;
}

void apply_overrides(Node& root, std::span<const Override> overrides, Problems& problems) {
  for (std::size_t k = 0; k < overrides.size(); ++k) apply(root, overrides[k].text, static_cast<int>(k), problems);
}

}  // namespace sandsim
