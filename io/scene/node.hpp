// A scene file as a tree of values, each with the place it was written at.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sandsim {

/// Where a value was written: in the file, or on the command line (`--set`).
struct Position {
  int line = 0;          // from 1; 0: in no line
  int column = 0;        // from 1
  int override_at = -1;  // index of the `--set` that the value comes from; -1: from the file
};

/// A scalar, a list or a map. In a map, `key` names each child; a node's position is then that of its key.
struct Node {
  enum class Kind { null, scalar, list, map };

  Kind kind = Kind::null;
  Position position;
  std::string key;             // empty unless the parent is a map
  std::string text;            // scalars only
  bool quoted = false;         // scalars only
  std::vector<Node> children;  // lists and maps

  const Node* find(std::string_view name) const;
  Node* find(std::string_view name);
};

/// The node on one line as it might have been written, control characters escaped, cut after `limit` bytes.
std::string shown(const Node& node, std::size_t limit = 60);

/// Text made safe for one line of a message: control characters escaped, cut after `limit` bytes.
std::string shown(std::string_view text, std::size_t limit = 60);

}  // namespace sandsim
