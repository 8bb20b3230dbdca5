#include <fmt/format.h>

#include "cli/stress/case_raster.hpp"
#include "cli/stress/matrix.hpp"

namespace sandsim::cli {

namespace {

SceneText dam() {
  return {};
}

SceneText column() {
  SceneText scene;
  scene.grid = "{cells: [32, 32], spacing: 1 cm}";
  scene.initial = "{type: column, center: [16 cells, 16 cells], radius: 6 cells, depth: 10 cm}";
  scene.end = 0.3;
  return scene;
}

/// The scene with a map of friction angles [deg].
StressCase with_map(const std::string& name, const std::string& meaning, SceneText scene, const CaseRaster& map) {
  scene.friction = fmt::format("friction_angle: {{raster: {}, unit: deg}}", map.file);
  StressCase made{name, meaning, scene};
  made.rasters = {map};
  return made;
}

void add_angles(std::vector<StressCase>& cases) {
  for (const char* angle : {"0", "0.01", "1", "10", "45", "60", "85", "89", "89.9", "89.99"}) {
    for (const auto& [shape, scene] : {std::pair("dam", dam()), std::pair("column", column())}) {
      StressCase made{fmt::format("friction_{}_{}deg", shape, angle),
                      fmt::format("{} of sand with a friction angle of {} deg", shape, angle), scene};
      made.scene.friction = fmt::format("friction_angle: {} deg", angle);
      cases.push_back(made);
    }
  }
}

void add_coefficients(std::vector<StressCase>& cases) {
  for (const char* coefficient : {"1e-12", "1e6", "1e12", "1e30"}) {
    StressCase made{fmt::format("friction_coefficient_{}", coefficient),
                    fmt::format("column with a friction coefficient of {}", coefficient), column()};
    made.scene.friction = fmt::format("friction_coefficient: {}", coefficient);
    cases.push_back(made);
  }
}

void add_refusals(std::vector<StressCase>& cases) {
  for (const auto& [name, value] : {std::pair("90deg", "90 deg"), std::pair("negative", "-1 deg")}) {
    StressCase made{fmt::format("friction_refused_{}", name),
                    fmt::format("a friction angle of {} cannot be run and is refused", value), dam()};
    made.scene.friction = fmt::format("friction_angle: {}", value);
    made.criteria.ending = ExitCode::invalid_scene;
    made.criteria.message = "sand.friction_angle";
    cases.push_back(made);
  }
}

void add_jumps(std::vector<StressCase>& cases) {
  const auto map_1d = [](const std::string& file, const auto& angle) {
    return make_raster(file, 64, 1, [&](int i, int) { return angle(i); });
  };
  const auto map_2d = [](const std::string& file, const auto& angle) {
    return make_raster(file, 32, 32, [&](int i, int j) { return angle(i, j); });
  };
  cases.push_back(with_map("friction_jump_up", "a dam runs from 0 deg onto 89.9 deg", dam(),
                           map_1d("friction_jump_up.npy", [](int i) { return i < 24 ? 0.0 : 89.9; })));
  cases.push_back(with_map("friction_jump_down", "a dam runs from 89.9 deg onto 0 deg", dam(),
                           map_1d("friction_jump_down.npy", [](int i) { return i < 18 ? 89.9 : 0.0; })));
  cases.push_back(with_map("friction_stripes", "a dam over stripes of one cell of 0 and 89.9 deg", dam(),
                           map_1d("friction_stripes.npy", [](int i) { return i % 2 == 0 ? 0.0 : 89.9; })));
  cases.push_back(with_map("friction_one_rough_cell", "one cell of 89.9 deg in a frictionless dam break", dam(),
                           map_1d("friction_one_rough_cell.npy", [](int i) { return i == 25 ? 89.9 : 0.0; })));
  cases.push_back(with_map("friction_one_smooth_cell", "one cell of 0 deg in sand of 60 deg", dam(),
                           map_1d("friction_one_smooth_cell.npy", [](int i) { return i == 20 ? 0.0 : 60.0; })));
  cases.push_back(
      with_map("friction_checkerboard", "a column on a checkerboard of 0.01 and 89.9 deg", column(),
               map_2d("friction_checkerboard.npy", [](int i, int j) { return (i + j) % 2 ? 0.01 : 89.9; })));
  cases.push_back(with_map("friction_half", "a column half on 0, half on 89.9 deg", column(),
                           map_2d("friction_half.npy", [](int i, int) { return i < 16 ? 0.0 : 89.9; })));
  cases.push_back(with_map("friction_random", "a column on random friction angles of 0 to 89.9 deg", column(),
                           make_noise("friction_random.npy", 32, 32, 89.9, 1)));
}

/// Sand that stands: nothing may move.
void add_rest(std::vector<StressCase>& cases) {
  SceneText layer = column();
  layer.initial = "{type: layer, depth: 3.7 cm}";
  cases.push_back(
      with_map("friction_rest_layer", "a level layer at rest on a checkerboard of 0 and 89.9 deg", layer,
               make_raster("friction_rest_layer.npy", 32, 32, [](int i, int j) { return (i + j) % 2 ? 0.0 : 89.9; })));
  SceneText pile = column();
  pile.friction = "friction_coefficient: 0.5";
  // A cone's steepest face falls by slope * dx along an axis; 0.49 leaves room for the rounding of its depths.
  pile.initial = "{type: cone, center: [16 cells, 16 cells], radius: 12 cells, height: 5.88 cm}";
  cases.push_back({"friction_rest_cone", "a cone at 0.98 of the friction coefficient", pile});
  SceneText wall = dam();
  wall.friction = "friction_angle: 89.99 deg";
  cases.push_back({"friction_rest_wall", "a step of ten cells held by 89.99 deg", wall});
  for (std::size_t k = cases.size() - 3; k < cases.size(); ++k) {
    cases[k].criteria.rest_kept = true;
  }
}

}  // namespace

std::vector<StressCase> friction_cases() {
  std::vector<StressCase> cases;
  add_angles(cases);
  add_coefficients(cases);
  add_refusals(cases);
  add_jumps(cases);
  add_rest(cases);
  return cases;
}

}  // namespace sandsim::cli
