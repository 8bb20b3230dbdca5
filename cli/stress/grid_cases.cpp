#include <fmt/format.h>

#include <algorithm>

#include "cli/stress/matrix.hpp"

namespace sandsim::cli {

namespace {

constexpr const char* periodic = "{x_min: periodic, x_max: periodic, y_min: periodic, y_max: periodic}";
constexpr const char* open = "{x_min: open, x_max: open, y_min: open, y_max: open}";

/// Sand in the corner at the origin: a third of each side, at least a cell.
SceneText heap(int nx, int ny) {
  SceneText scene;
  scene.grid = fmt::format("{{cells: [{}, {}], spacing: 1 cm}}", nx, ny);
  scene.initial = fmt::format("{{type: box, from: [0 m, 0 m], to: [{} cells, {} cells], depth: 8 cm}}",
                              std::max(1, nx / 3), std::max(1, ny / 3));
  scene.end = 0.3;
  return scene;
}

void add_shapes(std::vector<StressCase>& cases) {
  for (const auto& [nx, ny] : {std::pair(1, 1), std::pair(2, 1), std::pair(1, 64), std::pair(2, 2), std::pair(3, 3),
                               std::pair(2, 64), std::pair(64, 2), std::pair(7, 11), std::pair(13, 17),
                               std::pair(31, 37), std::pair(101, 3), std::pair(997, 1)}) {
    for (const auto& [kind, boundaries] :
         {std::pair("walls", ""), std::pair("periodic", periodic), std::pair("open", open)}) {
      StressCase made{fmt::format("grid_{}x{}_{}", nx, ny, kind),
                      fmt::format("a heap on {} x {} cells, {}", nx, ny, kind), heap(nx, ny)};
      made.scene.boundaries = boundaries;
      cases.push_back(made);
    }
  }
}

void add_mixed(std::vector<StressCase>& cases) {
  StressCase slope{"grid_open_below", "sand slides off a slope of 45 deg through an open side", heap(31, 7)};
  slope.scene.terrain = "{type: plane, inclination: 45 deg}";
  slope.scene.boundaries = "{x_max: open}";
  cases.push_back(slope);
  StressCase deep{"grid_open_deep", "50 m of sand drains through open sides", heap(31, 31)};
  deep.scene.initial = "{type: layer, depth: 50 m}";
  deep.scene.friction = "friction_angle: 1 deg";
  cases.push_back(deep);
  StressCase ring{"grid_ring", "a wave round a periodic strip without friction", heap(101, 3)};
  ring.scene.boundaries = "{x_min: periodic, x_max: periodic}";
  ring.scene.friction = "friction_angle: 0 deg";
  cases.push_back(ring);
}

}  // namespace

std::vector<StressCase> grid_cases() {
  std::vector<StressCase> cases;
  add_shapes(cases);
  add_mixed(cases);
  return cases;
}

}  // namespace sandsim::cli
