#include <fmt/format.h>

#include "cli/stress/matrix.hpp"

namespace sandsim::cli {

namespace {

/// Times follow sqrt(spacing/gravity), so that every scale sees the same motion.
SceneText scaled_dam(double spacing, double end) {
  SceneText scene;
  scene.grid = fmt::format("{{cells: [64, 1], spacing: {} m}}", spacing);
  scene.initial = "{type: box, from: [0 m, 0 m], to: [20 cells, 1 cells], depth: 10 cells}";
  scene.end = end;
  return scene;
}

SceneText scaled_column(double spacing, double end) {
  SceneText scene = scaled_dam(spacing, end);
  scene.grid = fmt::format("{{cells: [24, 24], spacing: {} m}}", spacing);
  scene.initial = "{type: column, center: [12 cells, 12 cells], radius: 5 cells, depth: 10 cells}";
  return scene;
}

void add_spacings(std::vector<StressCase>& cases) {
  for (const auto& [spacing, end] : {std::pair(1e-5, 0.01), std::pair(1e-3, 0.1), std::pair(1.0, 3.0),
                                     std::pair(1e3, 100.0), std::pair(1e6, 3000.0)}) {
    cases.push_back({fmt::format("scale_spacing_{:g}_dam", spacing), fmt::format("a dam in cells of {:g} m", spacing),
                     scaled_dam(spacing, end)});
    cases.push_back({fmt::format("scale_spacing_{:g}_column", spacing),
                     fmt::format("a column in cells of {:g} m", spacing), scaled_column(spacing, end)});
  }
}

void add_gravities(std::vector<StressCase>& cases) {
  for (const auto& [gravity, end] : {std::pair(0.0, 1.0), std::pair(1e-6, 1000.0), std::pair(1.6, 1.0),
                                     std::pair(1e3, 0.03), std::pair(1e6, 1e-3)}) {
    StressCase dam{fmt::format("scale_gravity_{:g}_dam", gravity), fmt::format("a dam at {:g} m/s^2", gravity),
                   scaled_dam(0.01, end)};
    dam.scene.gravity = fmt::format("{} m/s^2", gravity);
    StressCase column{fmt::format("scale_gravity_{:g}_column", gravity), fmt::format("a column at {:g} m/s^2", gravity),
                      scaled_column(0.01, end)};
    column.scene.gravity = dam.scene.gravity;
    dam.criteria.rest_kept = column.criteria.rest_kept = gravity == 0.0;
    cases.push_back(dam);
    cases.push_back(column);
  }
  StressCase moving{"scale_gravity_0_moving", "a column that moves at 1 m/s without gravity",
                    scaled_column(0.01, 0.05)};
  moving.scene.gravity = "0 m/s^2";
  moving.scene.initial =
      "{type: column, center: [12 cells, 12 cells], radius: 5 cells, depth: 10 cells, velocity: [1 m/s, 0.5 m/s]}";
  cases.push_back(moving);
}

void add_places(std::vector<StressCase>& cases) {
  StressCase far{"scale_far_origin", "cells of 1 mm at 1e6 m from the origin", scaled_column(1e-3, 0.1)};
  far.scene.grid = "{cells: [24, 24], spacing: 1 mm, origin: [1000 km, -1000 km]}";
  far.scene.initial = "{type: column, center: [1000000.012 m, -999999.988 m], radius: 5 mm, depth: 1 cm}";
  cases.push_back(far);
  StressCase high{"scale_high_plain", "a column on a plain at 1e4 m", scaled_column(0.01, 0.3)};
  high.scene.terrain = "{type: flat, elevation: 1e4 m}";
  cases.push_back(high);
  StressCase slope{"scale_high_slope", "a column on a slope at 1e4 m, where float32 holds the bed to 1 mm",
                   scaled_column(0.01, 0.3)};
  slope.scene.terrain = "{type: plane, inclination: 20 deg, elevation: 1e4 m}";
  cases.push_back(slope);
  StressCase too_far{"scale_refused_origin", "cells of 1 mm at 1e8 m from the origin are refused",
                     scaled_column(1e-3, 0.1)};
  too_far.scene.grid = "{cells: [24, 24], spacing: 1 mm, origin: [100000 km, 0 m]}";
  too_far.scene.initial = "{type: layer, depth: 1 cm}";
  too_far.criteria.ending = ExitCode::invalid_scene;
  too_far.criteria.message = "the grid lies too far away";
  cases.push_back(too_far);
}

}  // namespace

std::vector<StressCase> scale_cases() {
  std::vector<StressCase> cases;
  add_spacings(cases);
  add_gravities(cases);
  add_places(cases);
  return cases;
}

}  // namespace sandsim::cli
