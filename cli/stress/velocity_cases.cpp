#include <fmt/format.h>

#include "cli/stress/case_raster.hpp"
#include "cli/stress/matrix.hpp"

namespace sandsim::cli {

namespace {

/// Two boxes that fill the grid, each with its velocity, in m/s. Runs until sand has crossed the grid.
SceneText two_streams(const char* cells, const char* left, const char* right, double fastest) {
  SceneText scene;
  scene.grid = fmt::format("{{cells: {}, spacing: 1 cm}}", cells);
  scene.initial = fmt::format(
      "[{{type: box, from: [0 m, 0 m], to: [16 cells, 32 cells], depth: 5 cm, velocity: {}}}, "
      "{{type: box, from: [16 cells, 0 m], to: [32 cells, 32 cells], depth: 5 cm, velocity: {}}}]",
      left, right);
  scene.end = 0.32 / fastest;
  return scene;
}

void add_pairs(std::vector<StressCase>& cases) {
  for (const auto& [grid, cells] : {std::pair("1d", "[32, 1]"), std::pair("2d", "[32, 32]")}) {
    for (const double speed : {1.0, 30.0, 1000.0}) {
      const std::string plus = fmt::format("[{} m/s, 0 m/s]", speed), minus = fmt::format("[-{} m/s, 0 m/s]", speed);
      cases.push_back({fmt::format("velocity_collide_{:g}_{}", speed, grid),
                       fmt::format("streams that collide at {:g} m/s each", speed),
                       two_streams(cells, plus.c_str(), minus.c_str(), speed)});
      cases.push_back({fmt::format("velocity_part_{:g}_{}", speed, grid),
                       fmt::format("streams that part at {:g} m/s each and leave a vacuum", speed),
                       two_streams(cells, minus.c_str(), plus.c_str(), speed)});
    }
  }
  cases.push_back({"velocity_shear", "streams that slide along each other at 100 m/s each",
                   two_streams("[32, 32]", "[0 m/s, 100 m/s]", "[0 m/s, -100 m/s]", 100.0)});
  cases.push_back({"velocity_oblique", "streams that meet obliquely at 100 m/s",
                   two_streams("[32, 32]", "[100 m/s, 50 m/s]", "[-70 m/s, -100 m/s]", 100.0)});
  cases.push_back({"velocity_part_diagonal", "streams that part along the diagonal at 1000 m/s",
                   two_streams("[32, 32]", "[-1000 m/s, -1000 m/s]", "[1000 m/s, 1000 m/s]", 1000.0)});
}

SceneText block(const char* cells, const char* velocity, double end) {
  SceneText scene;
  scene.grid = fmt::format("{{cells: {}, spacing: 1 cm}}", cells);
  scene.initial = fmt::format(
      "{{type: box, from: [8 cells, 8 cells], to: [20 cells, 20 cells], depth: 5 cm, velocity: {}}}", velocity);
  scene.end = end;
  return scene;
}

void add_blocks(std::vector<StressCase>& cases) {
  for (const char* angle : {"0", "30", "89.9"}) {
    StressCase made{fmt::format("velocity_block_{}deg", angle),
                    fmt::format("a block at 1000 m/s into a wall, {} deg", angle),
                    block("[32, 1]", "[1000 m/s, 0 m/s]", 5e-4)};
    made.scene.friction = fmt::format("friction_angle: {} deg", angle);
    cases.push_back(made);
  }
  cases.push_back(
      {"velocity_corner", "a block at 1000 m/s into a corner", block("[32, 32]", "[1000 m/s, 1000 m/s]", 5e-4)});
  StressCase out{"velocity_leaves", "a block at 1000 m/s leaves through open sides",
                 block("[32, 32]", "[1000 m/s, -1000 m/s]", 1e-3)};
  out.scene.boundaries = "{x_min: open, x_max: open, y_min: open, y_max: open}";
  cases.push_back(out);
  StressCase round{"velocity_periodic", "a block at 1000 m/s round a periodic grid, without friction",
                   block("[32, 32]", "[1000 m/s, 700 m/s]", 2e-3)};
  round.scene.boundaries = "{x_min: periodic, x_max: periodic, y_min: periodic, y_max: periodic}";
  round.scene.friction = "friction_angle: 0 deg";
  cases.push_back(round);
  StressCase thin{"velocity_thin", "a film of 1e-6 m at 1000 m/s over dry ground",
                  block("[32, 1]", "[1000 m/s, 0 m/s]", 5e-4)};
  thin.scene.initial =
      "{type: box, from: [8 cells, 0 m], to: [20 cells, 1 cells], depth: 1e-6 m, velocity: [1000 m/s, 0 m/s]}";
  cases.push_back(thin);
  StressCase weightless{"velocity_weightless", "streams that collide at 1000 m/s without gravity",
                        two_streams("[32, 32]", "[1000 m/s, 0 m/s]", "[-1000 m/s, 0 m/s]", 1000.0)};
  weightless.scene.gravity = "0 m/s^2";
  cases.push_back(weightless);
}

void add_terrain(std::vector<StressCase>& cases) {
  const auto on_bed = [&](const std::string& name, const std::string& meaning, SceneText scene,
                          const std::function<double(int, int)>& height, int ny) {
    scene.terrain = fmt::format("{{type: raster, file: {}.npy}}", name);
    StressCase made{name, meaning, scene};
    made.rasters = {make_raster(name + ".npy", 32, ny, height)};
    cases.push_back(made);
  };
  on_bed(
      "velocity_over_cliff", "a block at 100 m/s over a cliff of 100 cells", block("[32, 1]", "[100 m/s, 0 m/s]", 0.01),
      [](int i, int) { return i < 22 ? 1.0 : 0.0; }, 1);
  on_bed(
      "velocity_against_cliff", "a block at 100 m/s against a cliff of 100 cells",
      block("[32, 1]", "[100 m/s, 0 m/s]", 0.01), [](int i, int) { return i < 22 ? 0.0 : 1.0; }, 1);
  on_bed(
      "velocity_onto_spike", "a block at 100 m/s onto a spike of one cell, 100 high",
      block("[32, 32]", "[100 m/s, 0 m/s]", 0.01), [](int i, int j) { return i == 24 && j == 14 ? 1.0 : 0.0; }, 32);
  StressCase up{"velocity_up_slope", "a block at 100 m/s up a slope of 85 deg",
                block("[32, 1]", "[-100 m/s, 0 m/s]", 0.02)};
  up.scene.terrain = "{type: plane, inclination: 85 deg}";
  cases.push_back(up);
  StressCase down{"velocity_down_slope", "a block at 100 m/s down a slope of 85 deg",
                  block("[32, 1]", "[100 m/s, 0 m/s]", 0.02)};
  down.scene.terrain = up.scene.terrain;
  cases.push_back(down);
  StressCase thin_layer{"velocity_hbar", "streams that collide at 100 m/s with hbar of 1e-6 m",
                        two_streams("[32, 32]", "[100 m/s, 0 m/s]", "[-100 m/s, 0 m/s]", 100.0)};
  thin_layer.scene.hbar = "{policy: constant, depth: 1e-6 m}";
  cases.push_back(thin_layer);
}

}  // namespace

std::vector<StressCase> velocity_cases() {
  std::vector<StressCase> cases;
  add_pairs(cases);
  add_blocks(cases);
  add_terrain(cases);
  return cases;
}

}  // namespace sandsim::cli
