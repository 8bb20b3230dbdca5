// Reading of vector files: polygons of sand, and zones of a map.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "io/gis/gis.hpp"
#include "io/scene/reading.hpp"
#include "io/scene/value_text.hpp"
#include "solver/errors.hpp"

namespace sandsim {

void Reading::parse(const Node& node, const std::string& path, PolygonFile& target, const Rule& rule) {
  target.file = node.text;
  target.place = place_of(node);
  auto layer = std::make_shared<PolygonLayer>();
  if (const std::filesystem::path full = find_file(node, path, rule); !full.empty()) {
    try {
      *layer = gis(full.string()).read_polygons(full, {target.layer, target.attribute, crs_});
    } catch (const InputError& error) {
      complain_input(node, path, {"the polygons cannot be read", error.what(), ""});
    }
  }
  target.data = std::move(layer);
}

void Reading::parse_zones(const Node& node, const std::string& path, ScalarMap& target, const Rule& rule) {
  const std::string unit = map_unit(rule.dimension);
  const std::string like = "{polygons: zones.gpkg, attribute: phi, " + (unit.empty() ? "" : "unit: " + unit + ", ") +
                           "elsewhere: " + rule.example() + "}";
  std::vector<std::string> needed{"polygons", "attribute", "elsewhere"};
  if (!unit.empty()) needed.emplace_back("unit");
  for (const Node& child : node.children) {
    const bool is_known = std::find(needed.begin(), needed.end(), child.key) != needed.end() || child.key == "layer";
    if (!is_known) {
      complain_key(child.position, path + '.' + child.key, {"unknown key", "", "Write the zones like " + like + "."});
    }
  }
  for (const std::string& key : needed) {
    if (node.find(key) == nullptr) {
      complain_key(
          node.position, path + '.' + key,
          {"missing", key == "unit" ? "no unit is assumed" : "zones need it", "Write them like " + like + "."});
    }
  }
  ZoneMap zones;
  if (const Node* given = node.find("unit"); given != nullptr && !unit.empty()) {
    parse_name(*given, path + ".unit", {unit});
  }
  if (const Node* given = node.find("elsewhere")) parse(*given, path + ".elsewhere", zones.elsewhere, rule);
  if (const Node* given = node.find("layer")) parse(*given, path + ".layer", zones.polygons.layer, text());
  const Node* attribute = node.find("attribute");
  if (attribute != nullptr) parse(*attribute, path + ".attribute", zones.polygons.attribute, text().required());
  if (zones.polygons.attribute.empty()) return;
  const Node& file = *node.find("polygons");
  parse(file, path + ".polygons", zones.polygons, sandsim::file().like("zones.gpkg"));

  auto layer = std::make_shared<PolygonLayer>(*zones.polygons.data);
  for (PolygonFeature& zone : layer->features) {
    const double value = rule.dimension == Dimension::angle ? zone.value * std::numbers::pi / 180 : zone.value;
    if (!rule.holds(value)) {
      complain(*attribute, path + ".attribute",
               {"a zone has a value out of range", shortest_text(zone.value) + "; valid: " + rule.bounds_text(), ""});
      return;
    }
    zone.value = value;
  }
  zones.polygons.data = std::move(layer);
  target = std::move(zones);
}

}  // namespace sandsim
