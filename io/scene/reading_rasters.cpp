// Reading of rasters, maps and the coordinate reference system that they lie in.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>

#include "io/gis/gis.hpp"
#include "io/raster/read_raster.hpp"
#include "io/scene/fill_values.hpp"
#include "io/scene/map_reader.hpp"
#include "io/scene/parameters.hpp"
#include "io/scene/reading.hpp"
#include "io/scene/value_text.hpp"
#include "solver/errors.hpp"

namespace sandsim {

Raster Reading::as_on_file(const std::filesystem::path& file, const RasterRequest& request) {
  const RasterKey key{file, request.band, request.variable};
  if (like_ && like_->first == key) {
    Raster kept = std::move(like_->second);
    like_.reset();
    return kept;
  }
  Raster raster = read_raster(file, request);
  if (!grid_known_) like_.emplace(key, raster);
  return raster;
}

void Reading::load(const Node& node, const std::string& path, RasterFile& target, const Rule& rule) {
  auto raster = std::make_shared<Raster>();
  target.file = node.text;
  target.place = place_of(node);
  target.data = raster;
  const std::filesystem::path full = find_file(node, path, rule);
  if (full.empty()) return;
  try {
    *raster = as_on_file(full, {target.band.value_or(1), target.variable.value_or("")});
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
  MapReader members(*this, node, path);
  describe_request(members, map);
  load(*raster, path + ".raster", map, rule);
  target = std::move(map);
}

}  // namespace sandsim
