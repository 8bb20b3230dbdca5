#include "io/sweep/read_sweep.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <limits>
#include <sstream>
#include <utility>

#include "io/scene/problems.hpp"
#include "io/scene/yaml_tree.hpp"
#include "solver/errors.hpp"

namespace sandsim {

namespace fs = std::filesystem;

namespace {

const std::vector<std::string> known_keys{"scene", "set", "vary", "samples", "sampling", "seed"};
constexpr std::size_t whole_text = largest_scene_file;

std::string read_text(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  if (!stream) throw InputError(file.string() + ": the sweep cannot be read.");
  return text.str();
}

class SweepReader {
 public:
  explicit SweepReader(const fs::path& file)
      : folder_(file.parent_path()), problems_(file.string(), {}), root_(parse_yaml(read_text(file), problems_)) {}

  SweepPlan read() {
    for (const Node& child : root_.children) read_member(child);
    if (plan_.scene.empty()) complain(root_, {"no scene", "", "Add \"scene: scene.yaml\"."});
    problems_.throw_if_any();
    return std::move(plan_);
  }

 private:
  void complain(const Node& node, const Complaint& complaint) {
    problems_.add(node.position, node.key + (node.kind == Node::Kind::scalar ? " = " + shown(node) : ""), complaint);
  }

  void read_member(const Node& node) {
    if (node.key == "scene") {
      if (is_text(node)) plan_.scene = folder_ / node.text;
    } else if (node.key == "set") {
      read_set(node);
    } else if (node.key == "vary") {
      read_vary(node);
    } else if (node.key == "samples") {
      plan_.samples.count = static_cast<int>(read_count(node, std::numeric_limits<int>::max()));
    } else if (node.key == "seed") {
      plan_.samples.seed = read_count(node, std::numeric_limits<std::uint64_t>::max());
    } else if (node.key == "sampling") {
      read_sampling(node);
    } else {
      const std::string near = nearest(node.key, known_keys);
      problems_.add(node.position, node.key,
                    {"unknown key of a sweep", "",
                     (near.empty() ? "" : "Did you mean '" + near + "'? ") + "Valid keys: " + listed(known_keys) +
                         ". Keys of the scene go under set and vary."});
    }
  }

  bool is_text(const Node& node) {
    if (node.kind == Node::Kind::scalar && !node.text.empty()) return true;
    complain(node, {"a text is needed", "", ""});
    return false;
  }

  std::uint64_t read_count(const Node& node, std::uint64_t most) {
    std::uint64_t value = 0;
    const char* end = node.text.data() + node.text.size();
    const auto [stop, error] = std::from_chars(node.text.data(), end, value);
    if (node.kind != Node::Kind::scalar || error != std::errc{} || stop != end || value > most) {
      complain(node, {"a whole number is needed", "", ""});
    }
    return value;
  }

  void read_sampling(const Node& node) {
    if (node.text == "random") {
      plan_.samples.sampling = Sampling::random;
    } else if (node.text != "latin") {
      complain(node, {"unknown way of sampling", "", "Valid: latin or random."});
    }
  }

  void read_set(const Node& node) {
    if (node.kind != Node::Kind::map) {
      complain(node, {"a map is needed", "", "Write it like {time.end: 2 s}."});
      return;
    }
    for (const Node& child : node.children) plan_.overrides.push_back(child.key + '=' + shown(child, whole_text));
  }

  void read_vary(const Node& node) {
    if (node.kind == Node::Kind::map) {
      for (const Node& child : node.children) read_axis({&child});
    } else if (node.kind == Node::Kind::list) {
      for (const Node& entry : node.children) {
        std::vector<const Node*> together;
        for (const Node& child : entry.children) together.push_back(&child);
        if (entry.kind != Node::Kind::map || together.empty()) {
          complain(entry, {"a map is needed", "its keys vary together", "Write it like {grid.spacing: [1 cm, 2 cm]}."});
        } else {
          read_axis(together);
        }
      }
    } else {
      complain(node, {"a map is needed", "", "Write it like {sand.friction_angle: 20:40:8 deg}."});
    }
  }

  void read_axis(const std::vector<const Node*>& together) {
    std::vector<std::string> keys;
    std::vector<SweepValues> values;
    for (const Node* node : together) {
      Parsed<SweepValues> parsed = read_values(*node);
      if (const Complaint* complaint = std::get_if<Complaint>(&parsed)) {
        complain(*node, *complaint);
        return;
      }
      keys.push_back(node->key);
      values.push_back(std::get<SweepValues>(std::move(parsed)));
    }
    if (const std::optional<Complaint> complaint = add_axis(plan_, keys, std::move(values))) {
      problems_.add(together.front()->position, together.front()->key, *complaint);
    }
  }

  static Parsed<SweepValues> read_values(const Node& node) {
    if (node.kind == Node::Kind::scalar) return parse_sweep_values(node.text);
    if (node.kind != Node::Kind::list || node.children.empty()) {
      return Complaint{"no values", "", "Write a list, [20 deg, 30 deg], or a range, 20:40:5 deg."};
    }
    std::vector<std::string> values;
    for (const Node& child : node.children) values.push_back(shown(child, whole_text));
    return parse_sweep_list(std::move(values));
  }

  fs::path folder_;
  Problems problems_;
  Node root_;
  SweepPlan plan_;
};

}  // namespace

bool is_sweep_file(const fs::path& file) {
  try {
    Problems problems(file.string(), {});
    return parse_yaml(read_text(file), problems).find("scene") != nullptr;
  } catch (const Error&) {
    return false;
  }
}

SweepPlan read_sweep(const fs::path& file) {
  return SweepReader(file).read();
}

}  // namespace sandsim
