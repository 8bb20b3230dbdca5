#include <fmt/format.h>

#include <cmath>

#include "cli/stress/case_raster.hpp"
#include "cli/stress/matrix.hpp"

namespace sandsim::cli {

namespace {

/// 100 m of sand behind a dam, in cells of 5 m.
SceneText deep_dam() {
  SceneText scene;
  scene.grid = "{cells: [64, 1], spacing: 5 m}";
  scene.initial = "{type: box, from: [0 m, 0 m], to: [20 cells, 1 cells], depth: 100 m}";
  scene.end = 20.0;
  return scene;
}

/// The same as a column.
SceneText deep_column() {
  SceneText scene = deep_dam();
  scene.grid = "{cells: [24, 24], spacing: 5 m}";
  scene.initial = "{type: column, center: [12 cells, 12 cells], radius: 5 cells, depth: 100 m}";
  scene.end = 10.0;
  return scene;
}

StressCase with_hbar(const std::string& name, const std::string& meaning, SceneText scene, const std::string& hbar) {
  scene.hbar = hbar;
  return {name, meaning, scene};
}

void add_policies(std::vector<StressCase>& cases) {
  for (const char* depth : {"1e-12", "1e-6", "1e-3", "1", "100"}) {
    cases.push_back(with_hbar(fmt::format("hbar_constant_{}", depth),
                              fmt::format("hbar of {} m under 100 m of sand", depth), deep_dam(),
                              fmt::format("{{policy: constant, depth: {} m}}", depth)));
  }
  for (const char* scale : {"1e-8", "1e-4", "0.5", "1"}) {
    cases.push_back(with_hbar(fmt::format("hbar_scaled_{}", scale), fmt::format("hbar = {} h in 100 m of sand", scale),
                              deep_dam(), fmt::format("{{policy: scaled, scale: {}}}", scale)));
  }
  for (const auto& [scale, cap] : {std::pair("1e-6", "1e-6"), std::pair("1", "1e-6"), std::pair("0.8", "10")}) {
    cases.push_back(with_hbar(fmt::format("hbar_truncated_{}_{}", scale, cap),
                              fmt::format("hbar = min({} h, {} m) in 100 m of sand", scale, cap), deep_dam(),
                              fmt::format("{{policy: truncated, scale: {}, cap: {} m}}", scale, cap)));
  }
  for (const char* depth : {"1e-6", "1", "1000"}) {
    cases.push_back(with_hbar(fmt::format("hbar_column_{}", depth),
                              fmt::format("hbar of {} m in a column of 100 m", depth), deep_column(),
                              fmt::format("{{policy: constant, depth: {} m}}", depth)));
  }
}

void add_frictionless(std::vector<StressCase>& cases) {
  for (const char* depth : {"1e-6", "0.1"}) {
    StressCase made = with_hbar(fmt::format("hbar_frictionless_{}", depth),
                                fmt::format("hbar of {} m under 100 m of sand without friction", depth), deep_dam(),
                                fmt::format("{{policy: constant, depth: {} m}}", depth));
    made.scene.friction = "friction_angle: 0 deg";
    cases.push_back(made);
  }
}

void add_jumps(std::vector<StressCase>& cases) {
  const auto add = [&](const std::string& name, const std::string& meaning, const SceneText& scene,
                       const std::string& policy, const CaseRaster& map) {
    StressCase made = with_hbar(name, meaning, scene, fmt::format(fmt::runtime(policy), fmt::arg("file", map.file)));
    made.rasters = {map};
    cases.push_back(made);
  };
  const std::string cap = "{{policy: truncated, scale: 1, cap: {{raster: {file}, unit: m}}}}";
  const std::string scale = "{{policy: scaled, scale: {{raster: {file}}}}}";
  add("hbar_cap_jump", "hbar jumps from 1e-6 m to 100 m at the dam", deep_dam(), cap,
      make_raster("hbar_cap_jump.npy", 64, 1, [](int i, int) { return i < 20 ? 1e-6 : 100.0; }));
  add("hbar_cap_stripes", "hbar of 1e-6 and 100 m in turn from cell to cell", deep_dam(), cap,
      make_raster("hbar_cap_stripes.npy", 64, 1, [](int i, int) { return i % 2 == 0 ? 1e-6 : 100.0; }));
  add("hbar_scale_stripes", "hbar/h of 1e-6 and 1 in turn from cell to cell", deep_dam(), scale,
      make_raster("hbar_scale_stripes.npy", 64, 1, [](int i, int) { return i % 2 == 0 ? 1e-6 : 1.0; }));
  add("hbar_cap_checkerboard", "hbar of 1e-6 and 100 m on a checkerboard", deep_column(), cap,
      make_raster("hbar_cap_checkerboard.npy", 24, 24, [](int i, int j) { return (i + j) % 2 ? 1e-6 : 100.0; }));
  CaseRaster decades = make_noise("hbar_scale_random.npy", 24, 24, 8.0, 2);
  for (double& value : decades.values) {
    value = std::pow(10.0, -value);
  }
  add("hbar_scale_random", "hbar/h anywhere between 1e-8 and 1 from cell to cell", deep_column(), scale, decades);
}

/// A lake at rest on random ground, whatever hbar is.
void add_rest(std::vector<StressCase>& cases) {
  const CaseRaster bed = make_noise("hbar_lake_bed.npy", 24, 24, 8.0, 3);
  const CaseRaster caps =
      make_raster("hbar_lake_cap.npy", 24, 24, [](int i, int j) { return (i * j) % 3 ? 1e-6 : 2.0; });
  StressCase lake{"hbar_rest_lake", "a frictionless lake on random ground with caps of 1e-6 and 2 m", deep_column()};
  lake.scene.friction = "friction_angle: 0 deg";
  lake.scene.terrain = "{type: raster, file: hbar_lake_bed.npy}";
  lake.scene.hbar = "{policy: truncated, scale: 0.5, cap: {raster: hbar_lake_cap.npy, unit: m}}";
  lake.scene.initial = "{type: layer, surface: 4 m}";
  lake.rasters = {bed, caps};
  lake.criteria.rest_kept = true;
  lake.paper = central_difference;
  cases.push_back(lake);
}

}  // namespace

std::vector<StressCase> hbar_cases() {
  std::vector<StressCase> cases;
  add_policies(cases);
  add_frictionless(cases);
  add_jumps(cases);
  add_rest(cases);
  return cases;
}

}  // namespace sandsim::cli
