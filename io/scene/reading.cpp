#include "io/scene/reading.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "io/gis/gis.hpp"
#include "io/mesh/read_mesh.hpp"
#include "io/mesh/read_sdf.hpp"
#include "io/raster/read_csv.hpp"
#include "io/raster/read_raster.hpp"
#include "io/scene/fill_values.hpp"
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
std::filesystem::path Reading::find_file(const Node& node, const std::string& path, const Rule& rule) {
  if (node.kind != Node::Kind::scalar || node.text.empty() || node.text.find('\0') != std::string::npos) {
    complain(node, path, {"the name of a file is needed", "", "Write it like " + rule.example() + "."});
    return {};
  }
  const std::filesystem::path full = directory_ / node.text;
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(full, error);
  if (std::filesystem::is_regular_file(status)) return full;
  if (std::filesystem::exists(status)) {
    complain_input(node, path, {"not a file", "looked at " + shown(full.string(), 200), ""});
    return {};
  }
  const Complaint missing{"the file is missing", "looked for " + shown(full.string(), 200),
                          made_by_.empty() ? "" : "Run " + made_by_ + ", which writes it."};
  if (rule.may_be_missing) {
    warn(node, path, missing);
  } else {
    complain_input(node, path, missing);
  }
  return {};
}

void Reading::load(const Node& node, const std::string& path, RasterFile& target, const Rule& rule) {
  auto raster = std::make_shared<Raster>();
  target.file = node.text;
  target.place = place_of(node);
  target.data = raster;
  const std::filesystem::path full = find_file(node, path, rule);
  if (full.empty()) return;
  try {
    *raster = read_raster(full, {target.band.value_or(1), target.variable.value_or("")});
  } catch (const InputError& error) {
    complain_input(node, path, {"the raster cannot be read", error.what(), ""});
    return;
  }
  if (target.first_row && raster->has_georeference) {
    const std::string key = path.substr(0, path.rfind('.')) + ".first_row";
    if (failed(key)) return;
    complain_at(key, {"not used", shown(node) + " says by itself where its rows lie", "Remove it."});
  } else if (target.first_row == FirstRow::north) {
    raster->flip_rows();
  }
  check_crs(node, path, *raster);
  double smallest = std::numeric_limits<double>::infinity();
  double largest = -smallest;
  for (const double value : raster->values) {
    if (std::isnan(value)) continue;  // no data here
    smallest = std::min(smallest, value);
    largest = std::max(largest, value);
  }
  const std::optional<FillValue> fill = find_fill_value(*raster);
  const bool values_matter = grid_known_;  // not those of the raster that the grid is like
  if (fill && values_matter) warn(node, path, describe_fill_value(*fill));
  const bool is_angle = rule.dimension == Dimension::angle;
  const auto si = [is_angle](double value) { return is_angle ? value * std::numbers::pi / 180 : value; };
  if (smallest <= largest && !(rule.holds(si(smallest)) && rule.holds(si(largest)))) {
    complain(node, path,
             {"the raster holds values out of range",
              "from " + shortest_text(smallest) + " to " + shortest_text(largest) + "; valid: " + rule.bounds_text(),
              fill ? describe_fill_value(*fill).suggestion : ""});
  }
  std::transform(raster->values.begin(), raster->values.end(), raster->values.begin(), si);
}

void Reading::know_grid(const Grid& grid) {
  if (grid.spacing > 0.0) cell_ = grid.spacing;
  crs_ = grid.crs;
  grid_known_ = true;
}

void Reading::parse(const Node& node, const std::string& path, Crs& target, const Rule& rule) {
  std::string text;
  parse(node, path, text, rule);
  if (text.empty()) return;
  try {
    target = gis(text).find_crs(text);
  } catch (const InputError& error) {
    complain(node, path, {"no coordinate reference system", error.what(), ""});
  }
}

/// Coordinates of another CRS than the grid's would lie elsewhere; whether the grid has any is the scene's choice.
void Reading::check_crs(const Node& node, const std::string& path, const Raster& raster) {
  if (!grid_known_ || !raster.crs.known()) return;
  if (!crs_.known()) {
    warn(node, path,
         {"the results carry no CRS", "the raster is in " + raster.crs.name + ", the grid states none",
          "Add \"crs: " + raster.crs.name + "\" to the grid, or take the grid by \"like\"."});
  } else if (raster.crs != crs_ && !gis(node.text).is_same(raster.crs, crs_)) {
    complain(node, path,
             {"the raster is in another CRS than the grid", raster.crs.name + ", not " + crs_.name,
              "Project it: gdalwarp -t_srs " + crs_.name + " -r bilinear " + node.text + " projected.tif"});
  }
}

void Reading::parse(const Node& node, const std::string& path, RasterFile& target, const Rule& rule) {
  load(node, path, target, rule);
}

void Reading::parse(const Node& node, const std::string& path, ScalarMap& target, const Rule& rule) {
  if (node.kind != Node::Kind::map) {
    double value = 0.0;
    parse(node, path, value, rule);
    target = value;
    return;
  }
  if (node.find("polygons") != nullptr) {
    parse_zones(node, path, target, rule);
    return;
  }
  // The values of a map have no unit of their own, so that it is stated beside the file.
  const std::string unit = map_unit(rule.dimension);
  const std::string like = unit.empty() ? "{raster: map.asc}" : "{raster: map.asc, unit: " + unit + "}";
  for (const Node& child : node.children) {
    const bool known = child.key == "raster" || child.key == "first_row" || child.key == "band" ||
                       child.key == "variable" || (child.key == "unit" && !unit.empty());
    if (known) continue;
    complain_key(child.position, path + '.' + child.key, {"unknown key", "", "Write the map like " + like + "."});
  }
  if (const Node* given = node.find("unit"); given != nullptr && !unit.empty()) {
    if (parse_name(*given, path + ".unit", {unit}) == npos) return;
  } else if (!unit.empty()) {
    complain_key(node.position, path + ".unit", {"missing", "no unit is assumed", "Write the map like " + like + "."});
    return;
  }
  const Node* raster = node.find("raster");
  if (raster == nullptr) {
    complain_key(node.position, path + ".raster", {"missing", "the file of the map", "Write it like " + like + "."});
    return;
  }
  RasterFile map;
  if (const Node* given = node.find("first_row"); given != nullptr) {
    note(path + ".first_row", *given);
    const std::size_t index = parse_name(*given, path + ".first_row", enum_names<FirstRow>());
    if (index == npos) return;
    map.first_row = static_cast<FirstRow>(index);
  }
  if (const Node* given = node.find("band")) {
    int band = 1;
    parse(*given, path + ".band", band, number().at_least(1));
    map.band = band;
  }
  if (const Node* given = node.find("variable")) {
    std::string variable;
    parse(*given, path + ".variable", variable, text().required());
    map.variable = variable;
  }
  load(*raster, path + ".raster", map, rule);
  target = std::move(map);
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

void Reading::parse(const Node& node, const std::string& path, ScriptFile& target, const Rule& rule) {
  if (const std::filesystem::path full = find_file(node, path, rule); !full.empty()) {
    made_by_ = full.lexically_normal().string();
  }
  target.file = node.text;
}

void Reading::parse(const Node& node, const std::string& path, PathTable& target, const Rule& rule) {
  parse_table(node, path, target, rule, [](const std::filesystem::path& full) { return read_path_csv(full); });
}

}  // namespace sandsim
