#include <fmt/format.h>

#include <cmath>

#include "cli/stress/case_raster.hpp"
#include "cli/stress/matrix.hpp"

namespace sandsim::cli {

namespace {

constexpr double gravity = 9.8;  // [m/s^2] the scenes' own

/// The time that a wave on sand of this depth takes for so many cells. [s]
double crossing(double cells, double spacing, double depth) {
  return cells * spacing / std::sqrt(gravity * depth);
}

/// A dam of each depth in cells of 1 m: from films to columns of 1e5 cells.
void add_dams(std::vector<StressCase>& cases) {
  for (const double depth : {1e-6, 1e-3, 1.0, 1e3, 1e5}) {
    for (const char* angle : {"0", "30"}) {
      StressCase made{fmt::format("depth_dam_{:g}_{}deg", depth, angle),
                      fmt::format("a dam of {:g} m in cells of 1 m, {} deg", depth, angle),
                      {}};
      made.scene.grid = "{cells: [64, 1], spacing: 1 m}";
      made.scene.initial = fmt::format("{{type: box, from: [0 m, 0 m], to: [20 m, 1 m], depth: {} m}}", depth);
      made.scene.friction = fmt::format("friction_angle: {} deg", angle);
      made.scene.end = crossing(60.0, 1.0, depth);
      cases.push_back(made);
    }
  }
  StressCase film{"depth_dam_1e-8", "a dam of 1e-8 m in cells of 1 mm without friction", {}};
  film.scene.grid = "{cells: [64, 1], spacing: 1 mm}";
  film.scene.initial = "{type: box, from: [0 m, 0 m], to: [20 mm, 1 mm], depth: 1e-8 m}";
  film.scene.friction = "friction_angle: 0 deg";
  film.scene.end = crossing(60.0, 1e-3, 1e-8);
  cases.push_back(film);
}

/// Eq. 35: 0.4 m more in the left half, on a layer of depth B.
void add_layers(std::vector<StressCase>& cases) {
  for (const double layer : {1e-8, 1e-3, 1.0, 100.0, 1e4}) {
    for (const auto& [name, hbar] :
         {std::pair("full", "{policy: full}"), std::pair("0.2m", "{policy: constant, depth: 0.2 m}")}) {
      StressCase made{fmt::format("depth_eq35_B{:g}_{}", layer, name),
                      fmt::format("eq. 35: a dam of 0.4 m on a layer of {:g} m, hbar {}", layer, name),
                      {}};
      made.scene.grid = "{cells: [100, 1], spacing: 2 cm}";
      made.scene.friction = "friction_angle: 30.9 deg";
      made.scene.hbar = hbar;
      made.scene.initial = fmt::format(
          "[{{type: layer, depth: {} m}}, {{type: box, from: [0 m, 0 m], to: [1 m, 2 cm], depth: 0.4 m}}]", layer);
      made.scene.end = crossing(100.0, 0.02, 0.4 + (made.scene.hbar == "{policy: full}" ? layer : 0.0));
      cases.push_back(made);
    }
  }
}

void add_contrasts(std::vector<StressCase>& cases) {
  StressCase film{"depth_film_beside_100m", "a film of 1e-8 m beside 100 m of sand", {}};
  film.scene.grid = "{cells: [64, 1], spacing: 10 cm}";
  film.scene.initial =
      "[{type: box, from: [0 m, 0 m], to: [2 m, 1 cells], depth: 100 m}, "
      "{type: box, from: [2 m, 0 m], to: [6.4 m, 1 cells], depth: 1e-8 m}]";
  film.scene.end = 0.3;
  cases.push_back(film);
  CaseRaster decades = make_noise("depth_decades.npy", 32, 32, 13.0, 4);
  for (double& value : decades.values) {
    value = std::pow(10.0, value - 8.0);
  }
  for (const char* angle : {"0", "40"}) {
    StressCase mixed{fmt::format("depth_decades_{}deg", angle),
                     fmt::format("depths of 1e-8 to 1e5 m from cell to cell, {} deg", angle),
                     {}};
    mixed.scene.grid = "{cells: [32, 32], spacing: 1 m}";
    mixed.scene.friction = fmt::format("friction_angle: {} deg", angle);
    mixed.scene.initial = "{type: raster, file: depth_decades.npy}";
    mixed.scene.end = 0.3;
    mixed.rasters = {decades};
    cases.push_back(mixed);
  }
}

void add_rest(std::vector<StressCase>& cases) {
  StressCase lake{"depth_rest_lake_1e4m", "a frictionless lake of 1e4 m over random ground of 10 m", {}};
  lake.scene.grid = "{cells: [24, 24], spacing: 1 m}";
  lake.scene.friction = "friction_angle: 0 deg";
  lake.scene.terrain = "{type: raster, file: depth_lake_bed.npy}";
  lake.scene.initial = "{type: layer, surface: 1e4 m}";
  lake.scene.end = 1.0;
  lake.rasters = {make_noise("depth_lake_bed.npy", 24, 24, 10.0, 5)};
  lake.criteria.rest_kept = true;
  lake.paper = "eq. 11 evens out the depths of a lake on an uneven bed, which tilts its surface";
  cases.push_back(lake);
  StressCase film{"depth_rest_film", "a film of 1e-8 m at rest on a slope of 29 deg", {}};
  film.scene.terrain = "{type: plane, inclination: 29 deg}";
  film.scene.initial = "{type: layer, depth: 1e-8 m}";
  film.criteria.rest_kept = true;
  cases.push_back(film);
}

}  // namespace

std::vector<StressCase> depth_cases() {
  std::vector<StressCase> cases;
  add_dams(cases);
  add_layers(cases);
  add_contrasts(cases);
  add_rest(cases);
  return cases;
}

}  // namespace sandsim::cli
