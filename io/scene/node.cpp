#include "io/scene/node.hpp"

namespace sandsim {

const Node* Node::find(std::string_view name) const {
  for (const Node& child : children) {
    if (child.key == name) return &child;
  }
  return nullptr;
}

Node* Node::find(std::string_view name) {
  return const_cast<Node*>(static_cast<const Node&>(*this).find(name));
}

std::string shown(std::string_view text, std::size_t limit) {
  std::string result;
  for (const char c : text) {
    // A character of several bytes is not torn apart: the cut waits for the first byte of the next one.
    const bool inside_character = (static_cast<unsigned char>(c) & 0xC0) == 0x80;
    if (result.size() >= limit && !inside_character) return result + "...";
    if (c == '\n') {
      result += "\\n";
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) {
      result += '?';
    } else {
      result += c;
    }
  }
  return result;
}

namespace {

void write(const Node& node, std::size_t limit, std::string& result) {
  if (result.size() > limit) return;
  switch (node.kind) {
    case Node::Kind::null:
      result += "null";
      return;
    case Node::Kind::scalar:
      result += node.quoted ? '"' + node.text + '"' : node.text;
      return;
    case Node::Kind::list:
    case Node::Kind::map:
      break;
  }
  const bool map = node.kind == Node::Kind::map;
  result += map ? '{' : '[';
  for (std::size_t k = 0; k < node.children.size() && result.size() <= limit; ++k) {
    if (k > 0) result += ", ";
    if (map) result += node.children[k].key + ": ";
    write(node.children[k], limit, result);
  }
  result += map ? '}' : ']';
}

}  // namespace

std::string shown(const Node& node, std::size_t limit) {
  std::string result;
  write(node, limit, result);
  return shown(result, limit);
}

}  // namespace sandsim
