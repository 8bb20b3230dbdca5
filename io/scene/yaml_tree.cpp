#include "io/scene/yaml_tree.hpp"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <map>
#include <optional>
#include <sstream>
#include <utility>

namespace sandsim {

namespace {

constexpr std::size_t deepest = 64;
// A scene has tens of values; this stops alias bombs long before memory does.
constexpr std::size_t most_nodes = 100'000;

/// A problem after which there is no tree to go on with.
struct Unreadable {
  Position position;
  Complaint complaint;
};

/// Builds the tree from the parser's events.
class TreeBuilder : public YAML::EventHandler {
 public:
  TreeBuilder(Problems& problems, int override_at) : problems_(problems), override_at_(override_at) {}

  Node take() { return std::move(root_); }

  Position position(const YAML::Mark& mark) const {
    // The parser counts from 0 and marks the unknown with -1.
    return {mark.line + 1, mark.column + 1, override_at_};
  }

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (++documents_ > 1) fail(mark, {"a second document", "a scene is one YAML document", "Remove the '---'."});
  }
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    Node node;
    node.position = position(mark);
    close(mark, anchor, std::move(node));
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    reject_tag(mark, tag);
    Node node;
    node.kind = Node::Kind::scalar;
    node.position = position(mark);
    node.text = value;
    node.quoted = tag == "!";
    close(mark, anchor, std::move(node));
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const auto found = anchors_.find(anchor);
    if (found == anchors_.end()) fail(mark, {"an alias that contains itself", "it has no end", ""});
    count(mark, found->second.second);
    Node copy = found->second.first;
    append(mark, std::move(copy));
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(mark, tag, anchor, Node::Kind::list);
  }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(mark, tag, anchor, Node::Kind::map);
  }
  void OnSequenceEnd() override { close_container(); }
  void OnMapEnd() override { close_container(); }

 private:
  /// A list or map whose end has not come yet.
  struct Open {
    Node node;
    YAML::anchor_t anchor = YAML::NullAnchor;
    YAML::Mark mark;
    std::size_t nodes_before = 0;
    bool has_key = false;   // maps: a key is there and waits for its value
    std::string key;        // maps
    Position key_position;  // maps
    std::map<std::string, Position> keys;
  };

  [[noreturn]] void fail(const YAML::Mark& mark, Complaint complaint) const {
    throw Unreadable{position(mark), std::move(complaint)};
  }

  void reject_tag(const YAML::Mark& mark, const std::string& tag) const {
    if (tag.empty() || tag == "?" || tag == "!") return;
    fail(mark, {"the tag '" + shown(tag) + "'", "scenes have no tags", "Remove it."});
  }

  void count(const YAML::Mark& mark, std::size_t added) {
    nodes_ += added;
    if (nodes_ <= most_nodes) return;
    fail(mark, {"more than " + std::to_string(most_nodes) + " values, aliases expanded", "a scene needs far fewer",
                "Put fields of values into rasters."});
  }

  void open(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor, Node::Kind kind) {
    reject_tag(mark, tag);
    if (open_.size() >= deepest) {
      fail(mark, {"lists and maps nested deeper than " + std::to_string(deepest), "no scene needs that", ""});
    }
    if (waits_for_key()) fail_key(mark);
    Open container;
    container.node.kind = kind;
    container.node.position = position(mark);
    container.anchor = anchor;
    container.mark = mark;
    container.nodes_before = nodes_;
    open_.push_back(std::move(container));
  }

  void close_container() {
    Open done = std::move(open_.back());
    open_.pop_back();
    count(done.mark, 1);
    if (done.anchor != YAML::NullAnchor) anchors_[done.anchor] = {done.node, nodes_ - done.nodes_before};
    append(done.mark, std::move(done.node));
  }

  void close(const YAML::Mark& mark, YAML::anchor_t anchor, Node node) {
    count(mark, 1);
    if (anchor != YAML::NullAnchor) anchors_[anchor] = {node, 1};
    append(mark, std::move(node));
  }

  /// The path of the key that waits for its value.
  std::string path_of_key() const {
    std::string path;
    for (const Open& container : open_) {
      const bool list = container.node.kind == Node::Kind::list;
      path += (path.empty() ? "" : ".") + (list ? std::to_string(container.node.children.size()) : container.key);
    }
    return path;
  }

  bool waits_for_key() const {
    return !open_.empty() && open_.back().node.kind == Node::Kind::map && !open_.back().has_key;
  }

  [[noreturn]] void fail_key(const YAML::Mark& mark) const {
    fail(mark, {"a key that is not a word", "keys are words, not lists, maps or empty", ""});
  }

  void append(const YAML::Mark& mark, Node node) {
    if (open_.empty()) {
      root_ = std::move(node);
      return;
    }
    Open& parent = open_.back();
    if (waits_for_key()) {
      if (node.kind != Node::Kind::scalar) fail_key(mark);
      parent.key = std::move(node.text);
      parent.key_position = position(mark);
      parent.has_key = true;
      return;
    }
    if (parent.node.kind == Node::Kind::map) {
      parent.has_key = false;
      const auto [first, is_new] = parent.keys.try_emplace(parent.key, parent.key_position);
      if (!is_new) {
        problems_.add(parent.key_position, shown(path_of_key(), 200),
                      {"a duplicate key",
                       "first given in line " + std::to_string(first->second.line) + ", column " +
                           std::to_string(first->second.column),
                       "Remove one of the two."});
        return;
      }
      node.key = std::move(parent.key);
      node.position = parent.key_position;
    }
    parent.node.children.push_back(std::move(node));
  }

  Problems& problems_;
  int override_at_;
  int documents_ = 0;
  std::size_t nodes_ = 0;
  std::vector<Open> open_;
  std::map<YAML::anchor_t, std::pair<Node, std::size_t>> anchors_;  // the node, and how many it expands to
  Node root_;
};

bool is_utf8(const std::string& text) {
  for (std::size_t k = 0; k < text.size();) {
    const unsigned lead = static_cast<unsigned char>(text[k]);
    const std::size_t length = lead < 0x80   ? 1
                               : lead < 0xC2 ? 0
                               : lead < 0xE0 ? 2
                               : lead < 0xF0 ? 3
                               : lead < 0xF5 ? 4
                                             : 0;
    if (length == 0 || k + length > text.size()) return false;
    for (std::size_t i = 1; i < length; ++i) {
      if ((static_cast<unsigned char>(text[k + i]) & 0xC0) != 0x80) return false;
    }
    k += length;
  }
  return true;
}

void check_text(const std::string& text, int override_at) {
  const Position start{0, 0, override_at};
  if (text.size() > largest_scene_file) {
    throw Unreadable{start,
                     {"larger than 1 MiB", "a scene is a small text file", "Put fields of values into rasters."}};
  }
  if (text.find('\0') != std::string::npos) {
    throw Unreadable{start, {"a binary file", "it holds bytes of value 0; a scene is a text file in UTF-8", ""}};
  }
  if (!is_utf8(text)) throw Unreadable{start, {"not UTF-8", "a scene is a text file in UTF-8", "Save it as UTF-8."}};
}

/// The first line that starts with blanks and a tab. The parser's own message about these is hard to understand.
std::optional<Position> tab_in_indentation(const std::string& text) {
  int line = 1;
  for (std::size_t start = 0; start < text.size(); ++line) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    const std::size_t tab = text.find_first_not_of(' ', start);
    if (tab < end && text[tab] == '\t') return Position{line, static_cast<int>(tab - start) + 1, -1};
    start = end + 1;
  }
  return std::nullopt;
}

}  // namespace

Node parse_yaml(const std::string& text, Problems& problems, int override_at) {
  TreeBuilder builder(problems, override_at);
  try {
    check_text(text, override_at);
    std::istringstream stream(text);
    YAML::Parser parser(stream);
    while (parser.HandleNextDocument(builder)) {
    }
    Node root = builder.take();
    if (override_at < 0 && root.kind == Node::Kind::null) {
      throw Unreadable{{}, {"the scene is empty", "it holds no key", "Start with grid, sand and time."}};
    }
    return root;
  } catch (const Unreadable& unreadable) {
    problems.add(unreadable.position, "", unreadable.complaint);
  } catch (const YAML::Exception& error) {
    if (const std::optional<Position> tab = tab_in_indentation(text); tab && override_at < 0) {
      problems.add(*tab, "", {"a tab in the indentation", "YAML indents with spaces only", "Use spaces."});
    } else {
      problems.add(builder.position(error.mark), "",
                   {"not valid YAML", error.msg, override_at < 0 ? "" : "Put text with special characters in quotes."});
    }
  }
  problems.throw_if_any();
  return {};
}

}  // namespace sandsim
