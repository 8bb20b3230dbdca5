#include <fmt/format.h>

#include "cli/stress/case_raster.hpp"
#include "cli/stress/matrix.hpp"

namespace sandsim::cli {

namespace {

/// A column of 6 cells radius and 12 cells height. Heaps of a few centimetres stop within a second; the times are
/// longer where they have longer to go.
StressCase column(const std::string& name, const std::string& meaning, double end) {
  StressCase made{name, meaning, {}};
  made.scene.grid = "{cells: [40, 40], spacing: 1 cm}";
  made.scene.initial = "{type: column, center: [20 cells, 20 cells], radius: 6 cells, depth: 12 cm}";
  made.scene.end = end;
  made.scene.time = "stop_at_rest: true";
  made.criteria.stops = true;
  made.paper = mean_of_faces;
  return made;
}

}  // namespace

std::vector<StressCase> stopping_cases() {
  std::vector<StressCase> cases;
  for (const auto& [angle, end] : {std::pair("5", 10.0), std::pair("15", 5.0), std::pair("30", 5.0),
                                   std::pair("45", 5.0), std::pair("60", 5.0), std::pair("85", 5.0)}) {
    cases.push_back(
        column(fmt::format("stopping_{}deg", angle), fmt::format("a column of {} deg comes to rest", angle), end));
    cases.back().scene.friction = fmt::format("friction_angle: {} deg", angle);
  }
  for (const auto& [name, hbar] :
       {std::pair("constant", "{policy: constant, depth: 5 mm}"), std::pair("scaled", "{policy: scaled, scale: 0.1}"),
        std::pair("truncated", "{policy: truncated, scale: 0.8, cap: 5 cm}")}) {
    cases.push_back(
        column(fmt::format("stopping_hbar_{}", name), fmt::format("a column with hbar {} comes to rest", name), 20.0));
    cases.back().scene.hbar = hbar;
  }
  cases.push_back(column("stopping_map", "a column on random friction angles of 10 to 60 deg comes to rest", 60.0));
  cases.back().scene.friction = "friction_angle: {raster: stopping_map.npy, unit: deg}";
  cases.back().rasters = {make_noise("stopping_map.npy", 40, 40, 50.0, 10)};
  for (double& angle : cases.back().rasters[0].values) {
    angle += 10.0;
  }
  cases.push_back(column("stopping_halves", "a column half on 10 deg, half on 60 deg comes to rest", 60.0));
  cases.back().scene.friction = "friction_angle: {raster: stopping_halves.npy, unit: deg}";
  cases.back().rasters = {make_raster("stopping_halves.npy", 40, 40, [](int i, int) { return i < 20 ? 10.0 : 60.0; })};
  cases.push_back(column("stopping_ground", "a column on white noise of three cells comes to rest", 300.0));
  cases.back().scene.terrain = "{type: raster, file: stopping_ground.npy}";
  cases.back().rasters = {make_noise("stopping_ground.npy", 40, 40, 0.03, 11)};
  cases.push_back(column("stopping_slope", "a column on a slope of 20 deg comes to rest", 5.0));
  cases.back().scene.terrain = "{type: plane, inclination: 20 deg, direction: 30 deg}";
  cases.push_back(column("stopping_fast", "a column thrown at 3 m/s comes to rest", 10.0));
  cases.back().scene.initial =
      "{type: column, center: [12 cells, 12 cells], radius: 6 cells, depth: 12 cm, velocity: [3 m/s, 2 m/s]}";
  cases.push_back(column("stopping_source", "a heap that was poured in a corner comes to rest", 5.0));
  cases.back().scene.initial = "";
  cases.back().scene.sources = "[{center: [0 m, 0 m], radius: 3 cells, rate: 0.5 l/s, end: 2 s}]";
  cases.back().criteria.rise = 0.3;
  cases.back().criteria.volume_float32 = 1e-5;  // see source_cases.cpp
  for (const char* spacing : {"1e-4", "100"}) {
    cases.push_back(column(fmt::format("stopping_spacing_{}", spacing),
                           fmt::format("a column in cells of {} m comes to rest", spacing), 0.0));
    cases.back().scene.grid = fmt::format("{{cells: [40, 40], spacing: {} m}}", spacing);
    cases.back().scene.initial = "{type: column, center: [20 cells, 20 cells], radius: 6 cells, depth: 12 cells}";
  }
  cases[cases.size() - 2].scene.end = 0.5, cases.back().scene.end = 500.0;  // as 5 s in cells of 1 cm
  return cases;
}

}  // namespace sandsim::cli
