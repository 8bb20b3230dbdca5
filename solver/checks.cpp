#include "solver/checks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <variant>

#include "solver/checks_objects.hpp"
#include "solver/checks_reference.hpp"
#include "solver/grid_problems.hpp"
#include "solver/polygon_coverage.hpp"

namespace sandsim {

namespace {

using Issues = std::vector<Issue>;

/// A closed interval along x and one along y. [m]
struct Extent {
  std::array<double, 2> low{};
  std::array<double, 2> high{};
};

Extent extent(const Grid& grid) {
  Extent result{grid.origin, grid.origin};
  for (std::size_t k = 0; k < 2; ++k) result.high[k] += grid.cells[k] * grid.spacing;
  return result;
}

/// Whether the two have cells in common; with one row only x counts.
bool overlap(const Grid& grid, const Extent& other) {
  const Extent own = extent(grid);
  const std::size_t axes = grid.one_dimensional() ? 1 : 2;
  for (std::size_t k = 0; k < axes; ++k) {
    if (other.low[k] >= own.high[k] || other.high[k] <= own.low[k]) return false;
  }
  return true;
}

bool contains(const Grid& grid, const std::array<double, 2>& point) {
  const Extent own = extent(grid);
  const std::size_t axes = grid.one_dimensional() ? 1 : 2;
  for (std::size_t k = 0; k < axes; ++k) {
    if (!(point[k] >= own.low[k] && point[k] <= own.high[k])) return false;
  }
  return true;
}

// ---- grid -----------------------------------------------------------------------------------------------------------
void check_grid(const Grid& grid, Issues& issues) {
  const Extent own = extent(grid);
  for (std::size_t k = 0; k < 2; ++k) {
    // Neighbouring cell centres have to differ clearly in double precision: by 1e-10 of their coordinates.
    const double largest = std::max(std::abs(own.low[k]), std::abs(own.high[k]));
    if (std::isfinite(largest) && grid.spacing > 1e-10 * largest) continue;
    issues.push_back(
        {"grid.origin",
         "the grid lies too far away",
         "its coordinates reach " + number_text(largest) + " m, the spacing is " + number_text(grid.spacing) + " m",
         "Move the origin nearer to 0 m.",
         {"grid"}});
    return;
  }
}

// ---- sand -----------------------------------------------------------------------------------------------------------
Extent disc(const std::array<double, 2>& center, double radius) {
  return {{center[0] - radius, center[1] - radius}, {center[0] + radius, center[1] + radius}};
}

void check_inside(const Scene& scene, const std::string& key, const Extent& part, Issues& issues) {
  if (overlap(scene.grid, part)) return;
  issues.push_back({key, "lies outside the grid", grid_text(scene.grid), "", {"grid"}});
}

std::string spans(const Extent& part) {
  return "it spans x from " + number_text(part.low[0]) + " m to " + number_text(part.high[0]) + " m and y from " +
         number_text(part.low[1]) + " m to " + number_text(part.high[1]) + " m; ";
}

void check_polygons(const Scene& scene, const std::string& key, const PolygonFile& file, Issues& issues) {
  if (!file.data || file.data->features.empty()) return;
  const Bounds own = bounds_of(*file.data);
  if (overlap(scene.grid, {own.low, own.high})) return;
  issues.push_back({key,
                    "the layer of polygons lies outside the grid",
                    spans({own.low, own.high}) + grid_text(scene.grid),
                    "Set grid.origin to a corner of it, or mind the CRS of both.",
                    {"grid"}});
}

void check_raster(const Scene& scene, const std::string& key, const RasterFile& file, Issues& issues) {
  if (!file.data || !file.data->has_georeference || file.data->nx == 0 || file.data->ny == 0) return;
  const Raster& r = *file.data;
  const double half_x = 0.5 * r.spacing_x;
  const double half_y = 0.5 * r.spacing_y;
  const Extent own{{r.origin_x - half_x, r.origin_y - half_y},
                   {r.origin_x + static_cast<double>(r.nx) * r.spacing_x - half_x,
                    r.origin_y + static_cast<double>(r.ny) * r.spacing_y - half_y}};
  if (overlap(scene.grid, own)) return;
  issues.push_back({key,
                    "the raster lies outside the grid",
                    spans(own) + grid_text(scene.grid),
                    "Set grid.origin to a corner of the raster.",
                    {"grid"}});
}

void check_fill(const std::string& key, const Fill& fill, Issues& issues) {
  const std::vector<std::string> both{key + ".depth", key + ".surface", key + ".type"};
  if (fill.depth && fill.surface) {
    issues.push_back({key + ".surface", "both depth and surface", "a part is filled by a depth or up to a level",
                      "Remove one of the two.", both});
  } else if (!fill.depth && !fill.surface) {
    issues.push_back({key + ".depth", "missing", "a part needs a depth of sand, or a surface to fill up to",
                      "Add \"depth: 20 cm\" or \"surface: 20 cm\".", both});
  }
}

/// The rules of one part of the initial sand; `key` is its path.
struct PartChecks {
  const Scene& scene;
  std::string key;
  Issues& issues;

  void operator()(const SandBox& box) const {
    const char* const axes[] = {"x", "y"};
    for (std::size_t k = 0; k < (scene.grid.one_dimensional() ? 1U : 2U); ++k) {
      if (box.from[k] < box.to[k]) continue;
      issues.push_back({key + ".to",
                        "the box has no extent along " + std::string(axes[k]),
                        "to has to be larger than from",
                        "",
                        {key + ".from", key + ".type", "grid.spacing", "grid.cells"}});
      return;
    }
    check_inside(scene, key, {box.from, box.to}, issues);
    check_fill(key, box.fill, issues);
  }
  void operator()(const SandColumn& column) const {
    check_inside(scene, key, disc(column.center, column.radius), issues);
    check_fill(key, column.fill, issues);
  }
  void operator()(const SandCone& cone) const { check_inside(scene, key, disc(cone.center, cone.radius), issues); }
  void operator()(const SandLayer& layer) const { check_fill(key, layer.fill, issues); }
  void operator()(const SandRaster& raster) const { check_raster(scene, key + ".file", raster.file, issues); }
  void operator()(const SandPolygon& polygon) const {
    check_polygons(scene, key + ".file", polygon.file, issues);
    if (polygon.depth.has_value() == polygon.file.attribute.empty()) {
      check_values(polygon.file);
      return;
    }
    const std::vector<std::string> both{key + ".depth", key + ".attribute", key + ".type"};
    if (polygon.depth) {
      issues.push_back({key + ".depth", "both depth and attribute", "polygons have one depth or each its own",
                        "Remove one of the two.", both});
    } else {
      issues.push_back({key + ".depth", "missing", "polygons need a depth of sand, or an attribute that holds it",
                        "Add \"depth: 2 m\" or \"attribute: thickness\".", both});
    }
  }
  void check_values(const PolygonFile& file) const {
    if (!file.data || file.attribute.empty()) return;
    const auto is_negative = [](const PolygonFeature& feature) { return !(feature.value >= 0.0); };
    const auto& features = file.data->features;
    const auto found = std::find_if(features.begin(), features.end(), is_negative);
    if (found == features.end()) return;
    issues.push_back({key + ".attribute",
                      "a polygon has a negative depth",
                      number_text(found->value) + " in feature " + std::to_string(found - features.begin()) + " from 0",
                      "",
                      {key + ".file", key + ".type"}});
  }
};

void check_velocity(const Scene& scene, const std::string& key, const SandVelocity& velocity, Issues& issues) {
  if (!scene.grid.one_dimensional() || velocity[1] == 0.0) return;
  issues.push_back({key + ".velocity",
                    "sand that moves along y needs rows to move to",
                    "the grid has one row",
                    "Use \"0 m/s\" for y.",
                    {"grid.cells", key + ".type"}});
}

void check_sources(const Scene& scene, Issues& issues) {
  for (std::size_t k = 0; k < scene.sand.sources.size(); ++k) {
    const SandSource& source = scene.sand.sources[k];
    const std::string key = "sand.sources." + std::to_string(k);
    check_inside(scene, key, disc(source.center, source.radius), issues);
    if (source.end <= source.start) {
      issues.push_back({key + ".end",
                        "the source ends before it starts",
                        "it starts at " + number_text(source.start) + " s",
                        "",
                        {key + ".start"}});
    } else if (source.start >= scene.time.end) {
      issues.push_back({key + ".start",
                        "the source starts after the end of the run",
                        "time.end is " + number_text(scene.time.end) + " s",
                        "",
                        {"time.end"}});
    }
  }
}

void check_sand(const Scene& scene, Issues& issues) {
  const Sand& sand = scene.sand;
  if (sand.friction_angle && sand.friction_coefficient) {
    issues.push_back({"sand.friction_coefficient",
                      "both friction_angle and friction_coefficient",
                      "the coefficient is the tangent of the angle",
                      "Remove one of the two.",
                      {"sand.friction_angle"}});
  } else if (!sand.friction_angle && !sand.friction_coefficient) {
    issues.push_back({"sand.friction_angle",
                      "missing",
                      "sand needs its friction",
                      "Add \"friction_angle: 30 deg\" or \"friction_coefficient: 0.58\".",
                      {"sand.friction_coefficient"}});
  }
  const auto check_map = [&](const std::string& key, const ScalarMap& map) {
    if (const auto* file = std::get_if<RasterFile>(&map)) check_raster(scene, key, *file, issues);
    if (const auto* zones = std::get_if<ZoneMap>(&map)) check_polygons(scene, key, zones->polygons, issues);
  };
  if (sand.friction_angle) check_map("sand.friction_angle", *sand.friction_angle);
  if (sand.friction_coefficient) check_map("sand.friction_coefficient", *sand.friction_coefficient);
  check_map("sand.hbar.scale", sand.hbar.scale);
  check_map("sand.hbar.cap", sand.hbar.cap);
  if (sand.initial.empty() && sand.sources.empty()) {
    issues.push_back({"sand.initial",
                      "there is no sand",
                      "neither at the start nor from a source",
                      "Add \"initial: {type: box, ...}\".",
                      {"sand.sources"}});
  }
  for (std::size_t k = 0; k < sand.initial.size(); ++k) {
    const std::string key = "sand.initial." + std::to_string(k);
    std::visit(PartChecks{scene, key, issues}, sand.initial[k]);
    check_velocity(scene, key, std::visit([](const auto& part) { return part.velocity; }, sand.initial[k]), issues);
  }
  check_sources(scene, issues);
}

// ---- boundaries, time, output ---------------------------------------------------------------------------------------
void check_boundaries(const Boundaries& sides, Issues& issues) {
  const auto check_pair = [&](const std::string& low, BoundaryKind at_low, const std::string& high,
                              BoundaryKind at_high) {
    if ((at_low == BoundaryKind::periodic) == (at_high == BoundaryKind::periodic)) return;
    const bool low_is_periodic = at_low == BoundaryKind::periodic;
    issues.push_back({"boundaries." + (low_is_periodic ? low : high),
                      "periodic on one side only",
                      "what leaves there comes in at " + (low_is_periodic ? high : low),
                      "Make " + low + " and " + high + " both periodic, or neither.",
                      {"boundaries." + low, "boundaries." + high}});
  };
  check_pair("x_min", sides.x_min, "x_max", sides.x_max);
  check_pair("y_min", sides.y_min, "y_max", sides.y_max);
}

void check_time(const TimeControl& time, Issues& issues) {
  if (time.frame_interval > time.end) {
    issues.push_back({"time.frame_interval",
                      "longer than the run",
                      "time.end is " + number_text(time.end) + " s",
                      "Use at most \"" + number_text(time.end) + " s\".",
                      {"time.end"}});
  } else if (time.end / time.frame_interval > 1e6) {
    issues.push_back({"time.frame_interval",
                      "more than 1e6 frames",
                      "time.end is " + number_text(time.end) + " s",
                      "Use at least \"" + number_text(time.end / 1e6) + " s\".",
                      {"time.end"}});
  }
  if (time.minimum_step && *time.minimum_step > time.frame_interval) {
    issues.push_back({"time.minimum_step",
                      "longer than a frame",
                      "steps are shortened to end at frames, every " + number_text(time.frame_interval) + " s",
                      "",
                      {"time.frame_interval"}});
  }
  if (time.mode != TimeMode::fixed) return;
  const double steps = std::round(time.frame_interval / time.step);
  // Both are decimal numbers rounded to double and perhaps scaled by units: a few roundings, far below 1e-9.
  if (steps >= 1.0 && std::abs(time.frame_interval - steps * time.step) <= 1e-9 * time.frame_interval) return;
  const double nearest = std::max(1.0, steps) * time.step;
  issues.push_back({"time.frame_interval",
                    "not a whole number of steps",
                    "a step is " + number_text(time.step) + " s",
                    "Did you mean \"" + number_text(nearest) + " s\"?",
                    {"time.step", "time.mode"}});
}

void check_particles(const Grid& grid, const Particles& particles, Issues& issues) {
  const double parts = grid.spacing / particles.spacing;
  const double whole = std::max(1.0, std::round(parts));
  if (!(std::fabs(parts - whole) <= 1e-6 * whole)) {  // a spacing written in decimals, e.g. 3.33333 mm, passes
    issues.push_back({"particles.spacing",
                      "does not divide the grid's spacing",
                      "the cells of the particles are whole parts of a cell of the sand",
                      "Use 1 cells, 0.5 cells, 0.25 cells ...?",
                      {"grid.spacing"}});
  }
}

void check_output(const Scene& scene, Issues& issues) {
  const Output& output = scene.output;
  std::set<OutputField> fields;
  for (std::size_t k = 0; k < output.fields.size(); ++k) {
    if (fields.insert(output.fields[k]).second) continue;
    issues.push_back({"output.fields." + std::to_string(k), "given twice", "", "Remove it.", {}});
  }
  if (output.maxima && output.maxima->pressure && !scene.sand.density) {
    issues.push_back({"sand.density",
                      "missing",
                      "output.maxima.pressure is density times the square of the speed",
                      "Add \"density: 1500 kg/m^3\".",
                      {"output.maxima"}});
  }
  std::set<std::string> names;
  for (std::size_t k = 0; k < output.probes.size(); ++k) {
    const Probe& probe = output.probes[k];
    const std::string key = "output.probes." + std::to_string(k);
    if (!names.insert(probe.name).second) {
      issues.push_back({key + ".name", "another probe has this name", "probes are told apart by it", "", {}});
    }
    if (!contains(scene.grid, probe.at)) {
      issues.push_back({key + ".at", "lies outside the grid", grid_text(scene.grid), "", {"grid"}});
    }
  }
}

}  // namespace

std::vector<Issue> check(const Scene& scene) {
  Issues issues;
  check_grid(scene.grid, issues);
  for (std::size_t k = 0; k < scene.terrain.size(); ++k) {
    if (const RasterTerrain* part = std::get_if<RasterTerrain>(&scene.terrain[k])) {
      check_raster(scene, "terrain." + std::to_string(k) + ".file", part->file, issues);
    }
  }
  check_sand(scene, issues);
  check_boundaries(scene.boundaries, issues);
  check_time(scene.time, issues);
  check_objects(scene, issues);
  if (scene.particles) check_particles(scene.grid, *scene.particles, issues);
  check_output(scene, issues);
  if (scene.reference) check_reference(scene, issues);
  return issues;
}

}  // namespace sandsim
