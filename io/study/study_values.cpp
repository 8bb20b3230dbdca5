// The free values of a study: their reading and writing.
#include "io/scene/value_text.hpp"
#include "io/study/study_parameters.hpp"
#include "io/study/study_reader.hpp"

namespace sandsim {

namespace {

/// True if the text means the same inside brackets as it did where it was written.
bool is_plain(const std::string& text) {
  constexpr const char* indicators = ",[]{}#:&*!|>'\"%@`?";
  return !text.empty() && text.find_first_of(indicators) == std::string::npos;
}

std::string key_text(const std::string& key) {
  return is_plain(key) ? key : in_quotes(key);
}

std::string map_text(const std::vector<Node>& entries) {
  std::string text;
  for (const Node& entry : entries) text += (text.empty() ? "" : ", ") + key_text(entry.key) + ": " + flow_text(entry);
  return '{' + text + '}';
}

}  // namespace

std::string flow_text(const Node& node) {
  switch (node.kind) {
    case Node::Kind::null:
      return "null";
    case Node::Kind::scalar:
      return node.quoted || !is_plain(node.text) ? in_quotes(node.text) : node.text;
    case Node::Kind::map:
      return map_text(node.children);
    case Node::Kind::list:
      break;
  }
  std::string text;
  for (const Node& child : node.children) text += (text.empty() ? "" : ", ") + flow_text(child);
  return '[' + text + ']';
}

void parse_member(Reading& reading, const Node& node, const std::string& path, Settings& target) {
  if (reading.expect(node, path, Node::Kind::map, "{numerics.order: 1}")) target.entries = node.children;
}

void parse_member(Reading& reading, const Node& node, const std::string& path, Variations& target) {
  if (!reading.expect(node, path, Node::Kind::map, "{time.courant: [0.3, 0.6]}")) return;
  for (const Node& axis : node.children) {
    const std::string here = path + '.' + axis.key;
    if (!reading.expect(axis, here, Node::Kind::list, "[0.3, 0.6]")) continue;
    if (axis.children.empty()) reading.complain(axis, here, {"the list is empty", "at least one entry is needed", ""});
    if (axis.key == "grid.spacing" || axis.key == "grid.cells") {
      reading.complain(axis, here, {"not varied like this", "the domain would change", "Use spacings."});
    }
  }
  target.axes = node.children;
}

std::string value_text(const Settings& settings, const Rule&) {
  return map_text(settings.entries);
}

std::string value_text(const Variations& variations, const Rule&) {
  return map_text(variations.axes);
}

}  // namespace sandsim
