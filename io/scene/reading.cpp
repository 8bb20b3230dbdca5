#include "io/scene/reading.hpp"

#include <algorithm>
#include <utility>

#include "io/mesh/read_mesh.hpp"
#include "io/mesh/read_sdf.hpp"
#include "io/raster/read_csv.hpp"
#include "io/scene/value_text.hpp"
#include "solver/errors.hpp"
#include "solver/objects/distance_grid.hpp"
#include "solver/objects/mesh.hpp"

namespace sandsim {

namespace {

const char* kind_name(Node::Kind kind) {
  switch (kind) {
    case Node::Kind::null:
      return "nothing";
    case Node::Kind::scalar:
      return "a single value";
    case Node::Kind::list:
      return "a list";
    case Node::Kind::map:
      break;
  }
  return "a map";
}

bool contains(const std::string& outer, const std::string& inner) {
  return inner.starts_with(outer) && (inner.size() == outer.size() || inner[outer.size()] == '.');
}

Complaint out_of_range(const Rule& rule) {
  return {"out of range", "valid: " + rule.bounds_text(), ""};
}

}  // namespace

Reading::Reading(Problems& problems, std::filesystem::path directory, std::vector<std::string>* warnings)
    : problems_(problems), directory_(std::move(directory)), warnings_(warnings) {}

// ---- messages -------------------------------------------------------------------------------------------------------
std::string Reading::as_written(std::string path) const {
  for (const std::string& single : singles_) {
    if (contains(single + ".0", path)) path.erase(single.size(), 2);
  }
  return path;
}

void Reading::complain(const Node& node, const std::string& path, const Complaint& complaint) {
  failed_.insert(path);
  problems_.add(node.position, shown(as_written(path), 200) + " = " + shown(node), complaint);
}

void Reading::complain_key(const Position& position, const std::string& path, const Complaint& complaint) {
  failed_.insert(path);
  problems_.add(position, shown(as_written(path), 200), complaint);
}

void Reading::complain_input(const Node& node, const std::string& path, const Complaint& complaint) {
  failed_.insert(path);
  problems_.add_input(node.position, as_written(path) + " = " + shown(node), complaint);
}

void Reading::warn(const Node& node, const std::string& path, const Complaint& complaint) {
  if (warnings_ == nullptr) return;
  warnings_->push_back(problems_.format(node.position, as_written(path) + " = " + shown(node), complaint));
}

bool Reading::failed(const std::string& path) const {
  return std::any_of(failed_.begin(), failed_.end(),
                     [&](const std::string& other) { return contains(other, path) || contains(path, other); });
}

void Reading::complain_at(const std::string& path, const Complaint& complaint) {
  if (const auto found = given_.find(path); found != given_.end()) {
    complain(*found->second, path, complaint);
    return;
  }
  complain_key(place_of(path), path, complaint);
}

void Reading::warn_at(const std::string& path, const Complaint& complaint) {
  if (const auto found = given_.find(path); found != given_.end()) {
    warn(*found->second, path, complaint);
  } else if (warnings_ != nullptr) {
    warnings_->push_back(problems_.format(place_of(path), as_written(path), complaint));
  }
}

Position Reading::place_of(const std::string& path) const {
  for (std::size_t dot = path.rfind('.'); dot != std::string::npos && dot > 0; dot = path.rfind('.', dot - 1)) {
    const auto found = given_.find(path.substr(0, dot));
    if (found != given_.end()) return found->second->position;
  }
  return {1, 1, -1};
}

bool Reading::expect(const Node& node, const std::string& path, Node::Kind kind, const std::string& like) {
  if (node.kind == kind) return true;
  complain(node, path,
           {std::string(kind_name(kind)) + " is needed, not " + kind_name(node.kind), "",
            like.empty() ? "" : "Write it like " + like + "."});
  return false;
}

// ---- numbers and words ----------------------------------------------------------------------------------------------
void Reading::parse(const Node& node, const std::string& path, double& target, const Rule& rule) {
  if (!expect(node, path, Node::Kind::scalar, rule.example())) return;
  if (node.quoted && rule.dimension == Dimension::none) {
    complain(node, path, {"a number is needed, not text", "it is in quotes", "Remove the quotes."});
    return;
  }
  const Parsed<double> parsed = parse_quantity(node.text, rule.dimension, rule.has_cells ? cell_ : 0.0, rule.example());
  if (const Complaint* complaint = std::get_if<Complaint>(&parsed)) {
    complain(node, path, *complaint);
    return;
  }
  const double value = std::get<double>(parsed);
  if (!rule.holds(value)) {
    complain(node, path, out_of_range(rule));
    return;
  }
  target = value;
  if (path == "grid.spacing") cell_ = value;  // the grid's own origin may be in cells
}

void Reading::parse(const Node& node, const std::string& path, int& target, const Rule& rule) {
  if (!expect(node, path, Node::Kind::scalar, rule.example())) return;
  if (node.quoted) {
    complain(node, path, {"a number is needed, not text", "it is in quotes", "Remove the quotes."});
    return;
  }
  const Parsed<int> parsed = parse_count(node.text);
  if (const Complaint* complaint = std::get_if<Complaint>(&parsed)) {
    complain(node, path, *complaint);
  } else if (const int value = std::get<int>(parsed); !rule.holds(value)) {
    complain(node, path, out_of_range(rule));
  } else {
    target = value;
  }
}

void Reading::parse(const Node& node, const std::string& path, bool& target, const Rule&) {
  if (!expect(node, path, Node::Kind::scalar, "true")) return;
  if (node.quoted || (node.text != "true" && node.text != "false")) {
    complain(node, path, {"true or false is needed", "no other word is read as one of them", ""});
    return;
  }
  target = node.text == "true";
}

void Reading::parse(const Node& node, const std::string& path, std::string& target, const Rule& rule) {
  if (!expect(node, path, Node::Kind::scalar, rule.example_text)) return;
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; };
  if (std::any_of(node.text.begin(), node.text.end(), is_control)) {
    complain(node, path, {"control characters", "text is one line of printable characters", ""});
  } else if (rule.is_required && node.text.empty()) {
    complain(node, path, {"empty text", "a name is needed", ""});
  } else {
    target = node.text;
  }
}

std::size_t Reading::parse_name(const Node& node, const std::string& path, const std::vector<std::string>& names) {
  if (!expect(node, path, Node::Kind::scalar, names.front())) return npos;
  const auto found = std::find(names.begin(), names.end(), node.text);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  const std::string near = nearest(node.text, names);
  complain(node, path,
           {"unknown value", "",
            (near.empty() ? "" : "Did you mean '" + near + "'? ") + "Valid: " + alternatives(names) + '.'});
  return npos;
}

// ---- files ----------------------------------------------------------------------------------------------------------
bool Reading::expect_file_name(const Node& node, const std::string& path, const Rule& rule) {
  const bool is_name =
      node.kind == Node::Kind::scalar && !node.text.empty() && node.text.find('\0') == std::string::npos;
  if (!is_name) {
    complain(node, path, {"the name of a file is needed", "", "Write it like " + rule.example() + "."});
  }
  return is_name;
}

std::string Reading::way_to_make_files() const {
  if (made_by_.empty()) return "";
  std::error_code error;
  return std::filesystem::is_regular_file(made_by_, error)
             ? "Run " + made_by_.string() + ", which writes the files of this scene."
             : "made_by names the script that writes it, but " + made_by_.string() + " is missing, too.";
}

std::filesystem::path Reading::find_file(const Node& node, const std::string& path, const Rule& rule) {
  if (!expect_file_name(node, path, rule)) return {};
  const std::filesystem::path full = directory_ / node.text;
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(full, error);
  if (std::filesystem::is_regular_file(status)) return full;
  if (std::filesystem::exists(status)) {
    complain_input(node, path, {"not a file", "looked at " + shown(full.string(), 200), ""});
    return {};
  }
  const Complaint missing{"the file is missing", "looked for " + shown(full.string(), 200), way_to_make_files()};
  if (rule.may_be_missing) {
    warn(node, path, missing);
  } else {
    complain_input(node, path, missing);
  }
  return {};
}

template <class Table, class Read>
void Reading::parse_table(const Node& node, const std::string& path, Table& target, const Rule& rule, Read read) {
  const std::filesystem::path full = find_file(node, path, rule);
  if (!full.empty()) {
    try {
      target = read(full);
    } catch (const InputError& error) {
      complain_input(node, path, {"the table cannot be read", error.what(), ""});
    }
  }
  target.file = node.text;
}

void Reading::parse(const Node& node, const std::string& path, Profile& target, const Rule& rule) {
  parse_table(node, path, target, rule, [](const std::filesystem::path& full) { return read_profile_csv(full); });
}

void Reading::parse(const Node& node, const std::string& path, FrontCurve& target, const Rule& rule) {
  parse_table(node, path, target, rule, [](const std::filesystem::path& full) { return read_front_csv(full); });
}

void Reading::parse(const Node& node, const std::string& path, MeshFile& target, const Rule& rule) {
  auto mesh = std::make_shared<objects::TriangleMesh>();
  if (const std::filesystem::path full = find_file(node, path, rule); !full.empty()) {
    try {
      read_mesh_file(full, node, path, *mesh);
    } catch (const InputError& error) {
      complain_input(node, path, {"the mesh cannot be read", error.what(), ""});
    }
  }
  target = {node.text, std::move(mesh), nullptr};
}

void Reading::read_mesh_file(const std::filesystem::path& full, const Node& node, const std::string& path,
                             objects::TriangleMesh& mesh) {
  Warnings odd;
  mesh = read_mesh(full, &odd);
  for (const std::string& what : odd) warn(node, path, {"the file of the mesh is odd", what, ""});
  objects::RepairedMesh repaired = objects::repair(mesh);
  if (repaired.mesh.triangles.empty()) return;  // check() knows that this is no surface
  mesh = std::move(repaired.mesh);
  const objects::MeshDefects& defects = repaired.defects;
  if (defects.flipped_triangles > 0) {
    const bool is_mirrored = defects.flipped_triangles == mesh.triangles.size();
    warn(node, path,
         {is_mirrored ? "the mesh is inside out" : "some triangles of the mesh look inwards",
          std::to_string(defects.flipped_triangles) + " of " + std::to_string(mesh.triangles.size()) +
              " triangles are turned round",
          is_mirrored ? "Was it mirrored by the program that wrote it?" : ""});
  }
  if (!defects.is_closed()) {
    warn(node, path,
         {"the mesh is not closed",
          std::to_string(defects.open_edges) + " open and " + std::to_string(defects.non_manifold_edges) +
              " non-manifold edges; holes are taken as closed where half of the view is blocked",
          ""});
  }
}

void Reading::check_sign(objects::DistanceGrid& grid, const Node& node, const std::string& path) {
  const objects::Rim rim = objects::rim_of(grid);
  if (rim.inside == 0) return;
  const bool is_enclosed = rim.outside == 0;  // nothing can be inside all round its own border
  if (is_enclosed && std::none_of(grid.values.begin(), grid.values.end(), [](float value) { return value > 0.0F; })) {
    complain(node, path,
             {"no sample is outside", "distances are negative inside, and all of these are", "Turn their sign."});
  } else if (is_enclosed) {
    for (float& value : grid.values) value = -value;
    warn(node, path,
         {"the signed distances are positive inside",
          "they are negative all round the border of their box; negative is inside here", "Their sign is turned."});
  } else if (2 * rim.inside > rim.samples) {
    warn(node, path,
         {"most of the samples on the border of their box are inside",
          std::to_string(rim.inside) + " of " + std::to_string(rim.samples) +
              " are negative, and negative is inside; the sign is kept, since some are outside",
          "Are they positive inside? Then turn their sign."});
  }
}

void Reading::parse(const Node& node, const std::string& path, SdfFile& target, const Rule& rule) {
  auto grid = std::make_shared<objects::DistanceGrid>();
  if (const std::filesystem::path full = find_file(node, path, rule); !full.empty()) {
    try {
      *grid = read_sdf(full);
      check_sign(*grid, node, path);
    } catch (const InputError& error) {
      complain_input(node, path, {"the signed distance cannot be read", error.what(), ""});
    }
  }
  target = {node.text, std::move(grid)};
}

/// A scene that was copied away with its files does not need the script any more.
void Reading::parse(const Node& node, const std::string& path, ScriptFile& target, const Rule& rule) {
  if (expect_file_name(node, path, rule)) {
    target.file = node.text;
    made_by_ = (directory_ / node.text).lexically_normal();
  }
}

void Reading::parse(const Node& node, const std::string& path, PathTable& target, const Rule& rule) {
  parse_table(node, path, target, rule, [](const std::filesystem::path& full) { return read_path_csv(full); });
}

}  // namespace sandsim
