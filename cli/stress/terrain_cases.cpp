#include <fmt/format.h>

#include <cmath>

#include "cli/stress/case_raster.hpp"
#include "cli/stress/matrix.hpp"

namespace sandsim::cli {

namespace {

constexpr int side = 32;       // cells of the 2-D grids
constexpr double cell = 0.01;  // [m]
constexpr double cliff = 1.0;  // [m] 100 cells

SceneText strip() {
  return {};
}

SceneText field() {
  SceneText scene;
  scene.grid = "{cells: [32, 32], spacing: 1 cm}";
  scene.initial = "{type: column, center: [16 cells, 16 cells], radius: 6 cells, depth: 6 cm}";
  scene.end = 0.4;
  return scene;
}

StressCase on_bed(const std::string& name, const std::string& meaning, SceneText scene, CaseRaster bed) {
  bed.file = name + ".npy";
  scene.terrain = fmt::format("{{type: raster, file: {}}}", bed.file);
  StressCase made{name, meaning, scene};
  made.rasters = {std::move(bed)};
  return made;
}

CaseRaster bed_1d(const std::function<double(int)>& height) {
  return make_raster("", 64, 1, [&](int i, int) { return height(i); });
}

CaseRaster bed_2d(const std::function<double(int, int)>& height) {
  return make_raster("", side, side, height);
}

void add_slopes(std::vector<StressCase>& cases) {
  for (const char* angle : {"15", "30", "45", "60", "75", "85", "88.9"}) {
    StressCase dam{fmt::format("terrain_slope_{}deg_dam", angle),
                   fmt::format("a box of sand on a slope of {} deg, a wall at its foot", angle), strip()};
    dam.scene.terrain = fmt::format("{{type: plane, inclination: {} deg}}", angle);
    dam.scene.initial = "{type: box, from: [5 cells, 0 m], to: [25 cells, 1 cells], depth: 5 cm}";
    cases.push_back(dam);
  }
  for (const char* angle : {"45", "85"}) {
    StressCase column{fmt::format("terrain_slope_{}deg_diagonal", angle),
                      fmt::format("a column on a slope of {} deg along the grid's diagonal", angle), field()};
    column.scene.terrain = fmt::format("{{type: plane, inclination: {} deg, direction: 45 deg}}", angle);
    cases.push_back(column);
    StressCase film{fmt::format("terrain_slope_{}deg_film", angle),
                    fmt::format("a film of 1e-6 m on a slope of {} deg", angle), strip()};
    film.scene.terrain = fmt::format("{{type: plane, inclination: {} deg}}", angle);
    film.scene.initial = "{type: box, from: [5 cells, 0 m], to: [25 cells, 1 cells], depth: 1e-6 m}";
    cases.push_back(film);
  }
  StressCase refused{"terrain_refused_slope", "a slope of 90 deg is refused", strip()};
  refused.scene.terrain = "{type: plane, inclination: 90 deg}";
  refused.criteria.ending = ExitCode::invalid_scene;
  refused.criteria.message = "terrain.inclination";
  cases.push_back(refused);
}

void add_cliffs(std::vector<StressCase>& cases) {
  cases.push_back(on_bed("terrain_cliff_down", "a dam runs over a cliff of 100 cells", strip(),
                         bed_1d([](int i) { return i < 30 ? cliff : 0.0; })));
  StressCase edge = on_bed("terrain_cliff_edge", "sand that ends at the edge of a cliff of 100 cells", strip(),
                           bed_1d([](int i) { return i < 20 ? cliff : 0.0; }));
  cases.push_back(edge);
  cases.push_back(on_bed("terrain_cliff_up", "a dam runs against a cliff of 100 cells", strip(),
                         bed_1d([](int i) { return i < 30 ? 0.0 : cliff; })));
  cases.push_back(on_bed("terrain_stairs", "a dam down stairs of ten cells each", strip(),
                         bed_1d([](int i) { return i < 18 ? 4.0 : 4.0 - 0.1 * ((i - 18) / 2); })));
  cases.push_back(on_bed("terrain_cliff_diagonal", "a column over a cliff of 100 cells along the diagonal", field(),
                         bed_2d([](int i, int j) { return i + j < side + 4 ? cliff : 0.0; })));
  cases.push_back(on_bed("terrain_canyon", "a column over a canyon one cell wide and 100 deep", field(),
                         bed_2d([](int i, int) { return i == 20 ? 0.0 : cliff; })));
  cases.push_back(on_bed("terrain_ridge", "a column beside a ridge one cell wide and 100 high", field(),
                         bed_2d([](int i, int) { return i == 24 ? cliff : 0.0; })));
  StressCase mesa =
      on_bed("terrain_mesa", "sand on a mesa of 100 cells, frictionless", field(),
             bed_2d([](int i, int j) { return std::abs(i - 15) < 8 && std::abs(j - 15) < 8 ? cliff : 0.0; }));
  mesa.scene.friction = "friction_angle: 0 deg";
  cases.push_back(mesa);
}

void add_spikes(std::vector<StressCase>& cases) {
  const auto stream = [](SceneText scene) {
    scene.initial = "{type: box, from: [0 m, 0 m], to: [12 cells, 32 cells], depth: 10 cm, velocity: [2 m/s, 0 m/s]}";
    scene.friction = "friction_angle: 10 deg";
    return scene;
  };
  const auto at_center = [](int i, int j) { return i == 20 && j == 16; };
  cases.push_back(on_bed("terrain_spike", "a stream around a spike of one cell, 100 high", stream(field()),
                         bed_2d([=](int i, int j) { return at_center(i, j) ? cliff : 0.0; })));
  cases.push_back(on_bed("terrain_pit", "a stream over a pit of one cell, 100 deep", stream(field()),
                         bed_2d([=](int i, int j) { return at_center(i, j) ? -cliff : 0.0; })));
  cases.push_back(on_bed("terrain_spikes", "a stream among spikes of ten cells on every second cell", stream(field()),
                         bed_2d([](int i, int j) { return i % 2 + j % 2 == 2 ? 0.1 : 0.0; })));
  cases.push_back(on_bed("terrain_pits", "a stream over pits of 100 cells on every third cell", stream(field()),
                         bed_2d([](int i, int j) { return (i + j) % 3 == 0 ? -cliff : 0.0; })));
  cases.push_back(on_bed("terrain_spike_1d", "a dam against a spike of 100 cells in a single row", strip(),
                         bed_1d([](int i) { return i == 30 ? cliff : 0.0; })));
  cases.push_back(on_bed("terrain_pit_1d", "a dam over a pit of 100 cells in a single row", strip(),
                         bed_1d([](int i) { return i == 30 ? -cliff : 0.0; })));
  StressCase tower{"terrain_sand_tower", "a tower of sand of one cell, 100 high", field()};
  tower.scene.initial = "{type: box, from: [16 cells, 16 cells], to: [17 cells, 17 cells], depth: 1 m}";
  cases.push_back(tower);
  StressCase towers{"terrain_sand_towers", "towers of sand of 50 cells on every third cell", field()};
  towers.scene.initial = "{type: raster, file: terrain_sand_towers.npy}";
  towers.rasters = {make_raster("terrain_sand_towers.npy", side, side,
                                [](int i, int j) { return i % 3 == 0 && j % 3 == 0 ? 0.5 : 0.0; })};
  cases.push_back(towers);
}

void add_random(std::vector<StressCase>& cases) {
  for (const double cells : {1.0, 10.0, 100.0}) {
    for (const char* angle : {"0", "30", "60"}) {
      const std::string name = fmt::format("terrain_random_{:g}cells_{}deg", cells, angle);
      StressCase made = on_bed(name, fmt::format("a column on white noise of {:g} cells, {} deg", cells, angle),
                               field(), make_noise("", side, side, cells * cell, 6));
      made.scene.friction = fmt::format("friction_angle: {} deg", angle);
      cases.push_back(made);
    }
  }
  StressCase fast = on_bed("terrain_random_fast", "sand at 10 m/s across white noise of five cells", field(),
                           make_noise("", side, side, 5.0 * cell, 7));
  fast.scene.initial =
      "{type: box, from: [0 m, 0 m], to: [16 cells, 32 cells], depth: 5 cm, velocity: [10 m/s, 3 m/s]}";
  fast.scene.end = 0.1;
  cases.push_back(fast);
}

void add_rest(std::vector<StressCase>& cases) {
  StressCase slope{"terrain_rest_slope", "a layer on a slope of 85 deg, held by 86 deg", strip()};
  slope.scene.terrain = "{type: plane, inclination: 85 deg}";
  slope.scene.friction = "friction_angle: 86 deg";
  slope.scene.initial = "{type: layer, depth: 5 cm}";
  cases.push_back(slope);
  StressCase lake = on_bed("terrain_rest_lake", "a frictionless lake among islands of 100 cells", field(),
                           make_noise("", side, side, cliff, 8));
  lake.scene.friction = "friction_angle: 0 deg";
  lake.scene.initial = "{type: layer, surface: 50 cm}";
  lake.paper = central_difference;
  cases.push_back(lake);
  StressCase plateau = on_bed("terrain_rest_spikes", "level sand with friction among spikes and pits of 100 cells",
                              field(), bed_2d([](int i, int j) { return (i * 7 + j * 3) % 5 == 0 ? cliff : 0.0; }));
  plateau.scene.initial = "{type: layer, surface: 10 cm}";
  plateau.paper = central_difference;
  cases.push_back(plateau);
  StressCase valley = on_bed("terrain_rest_valley", "sand at 0.95 of its angle in a valley", field(),
                             bed_2d([](int i, int) { return 0.9 * cell * std::abs(i - 16); }));
  valley.scene.friction = "friction_coefficient: 0.95";
  valley.scene.initial = "{type: layer, depth: 2 cm}";
  cases.push_back(valley);
  for (std::size_t k = cases.size() - 4; k < cases.size(); ++k) {
    cases[k].criteria.rest_kept = true;
  }
}

}  // namespace

std::vector<StressCase> terrain_cases() {
  std::vector<StressCase> cases;
  add_slopes(cases);
  add_cliffs(cases);
  add_spikes(cases);
  add_random(cases);
  add_rest(cases);
  return cases;
}

}  // namespace sandsim::cli
