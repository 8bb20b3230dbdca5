#include <fmt/format.h>

#include "cli/stress/case_raster.hpp"
#include "cli/stress/matrix.hpp"

namespace sandsim::cli {

namespace {

constexpr int side = 24;  // cells

/// The maps are a survey of the paper's scheme, not a promise of it.
constexpr const char* surveyed = "the map shows where";

/// A column that collapses on rough ground.
StressCase courant_cell(double courant, double angle) {
  StressCase made{fmt::format("map_courant_{:g}_friction_{:g}", courant, angle),
                  fmt::format("a column on rough ground, Courant number {:g}, friction {:g} deg", courant, angle),
                  {}};
  made.scene.grid = fmt::format("{{cells: [{0}, {0}], spacing: 1 cm}}", side);
  made.scene.terrain = "{type: raster, file: map_ground.npy}";
  made.scene.friction = fmt::format("friction_angle: {} deg", angle);
  made.scene.initial = "{type: column, center: [12 cells, 12 cells], radius: 5 cells, depth: 8 cm}";
  made.scene.time = fmt::format("courant: {}", courant);
  made.scene.end = 0.2;
  made.criteria.step *= courant < 0.5 ? courant / 0.5 : 1.0;  // steps are shorter because they were asked to be
  made.place = MapPlace{"courant_friction", courant, angle};
  made.rasters = {make_noise("map_ground.npy", side, side, 0.02, 9)};
  return made;
}

/// A box of sand on a slope that ends at a wall.
StressCase hbar_cell(double ratio, double slope) {
  StressCase made{fmt::format("map_hbar_{:g}_slope_{:g}", ratio, slope),
                  fmt::format("a box on a slope of {:g} deg, hbar/h {:g}", slope, ratio),
                  {}};
  made.scene.grid = fmt::format("{{cells: [{0}, {0}], spacing: 1 cm}}", side);
  made.scene.terrain = fmt::format("{{type: plane, inclination: {} deg, direction: 30 deg}}", slope);
  made.scene.hbar = fmt::format("{{policy: scaled, scale: {}}}", ratio);
  made.scene.initial = "{type: box, from: [4 cells, 6 cells], to: [12 cells, 18 cells], depth: 8 cm}";
  made.scene.end = 1.0;
  made.place = MapPlace{"hbar_slope", ratio, slope};
  return made;
}

}  // namespace

std::vector<StressCase> stability_maps() {
  std::vector<StressCase> cells;
  for (const double angle : {0.0, 0.01, 1.0, 10.0, 20.0, 30.0, 45.0, 60.0, 75.0, 85.0, 89.9}) {
    for (const double courant : {0.05, 0.1, 0.2, 0.35, 0.5, 0.6, 0.75, 0.9, 1.0}) {
      cells.push_back(courant_cell(courant, angle));
    }
  }
  for (const double slope : {0.0, 15.0, 30.0, 45.0, 60.0, 70.0, 80.0, 85.0}) {
    for (const double ratio : {1e-6, 1e-5, 1e-4, 1e-3, 0.01, 0.1, 0.3, 0.6, 1.0}) {
      cells.push_back(hbar_cell(ratio, slope));
    }
  }
  for (StressCase& cell : cells) {
    cell.theme = "map";
    cell.paper = surveyed;
  }
  return cells;
}

}  // namespace sandsim::cli
