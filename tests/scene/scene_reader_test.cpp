#include "io/scene/scene_reader.hpp"

#include <filesystem>
#include <fstream>
#include <numbers>

#include "tests/scene/support.hpp"
#include "tests/support/catch.hpp"

using namespace sandsim;
using namespace sandsim::test;

namespace {

const char* const whole_scene = R"(
title: Everything at once
grid: {cells: [40, 30], spacing: 5 cm, origin: [-1 m, 2 cells]}
gravity: 9.81 m/s^2
terrain:
  - {type: flat, elevation: 1 m}
  - {type: plane, inclination: 20 deg, direction: 90 deg, elevation: 3 cm}
  - {type: raster, file: data/angles.asc, scale: 0.5, offset: -1 m}
sand:
  friction_coefficient: {raster: data/angles.asc}
  density: 1.5 g/cm^3
  hbar: {policy: truncated, scale: 0.8, cap: {raster: data/angles.asc, unit: m}}
  initial:
    - {type: box, from: [0 m, 50 cm], to: [40 cm, 1 m], depth: 20 cm, velocity: [36 km/h, -20 cm/s]}
    - {type: column, center: [0 m, 1 m], radius: 10 cm, surface: -1 cm}
    - {type: cone, center: [0 m, 1 m], radius: 10 cm, height: 5 cm}
    - {type: layer, depth: 1 mm}
    - {type: raster, file: data/angles.asc, scale: 0.1}
  sources:
    - {center: [0 m, 1 m], radius: 2 cm, rate: 2 l/s, start: 1 s, end: 2 min}
boundaries: {x_min: periodic, x_max: periodic, y_min: open}
time: {mode: fixed, step: 2 ms, subcycle: true, end: 3 s, frame_interval: 20 ms, stop_at_rest: true, minimum_step: 1 ms}
numerics: {scheme: paper, precision: float64, momentum_flux: printed, rest_gate: false, velocity: quotient}
objects: []
output:
  fields: [surface, momentum]
  frames: false
  maxima: {above: 2 mm, pressure: true}
  probes: [{name: gate, at: [0 m, 1 m]}]
  compression: gzip
  checkpoint_interval: 1 min
reference: {front_depths: [5 mm, 5 cm]}
)";

}  // namespace

TEST_CASE("every key of a scene arrives in SI units") {
  const Scene s = read(whole_scene);
  CHECK(s.title == "Everything at once");
  CHECK(s.grid.cells == std::array{40, 30});
  CHECK(s.grid.spacing == 0.05);
  CHECK(s.grid.origin == std::array{-1.0, 0.1});
  CHECK(s.gravity == 9.81);
  REQUIRE(s.terrain.size() == 3);
  CHECK(std::get<FlatTerrain>(s.terrain[0]).elevation == 1.0);
  CHECK(std::get<PlaneTerrain>(s.terrain[1]).inclination == 20 * std::numbers::pi / 180);
  CHECK(std::get<PlaneTerrain>(s.terrain[1]).direction == std::numbers::pi / 2);
  CHECK(std::get<RasterTerrain>(s.terrain[2]).scale == 0.5);
  CHECK(std::get<RasterTerrain>(s.terrain[2]).offset == -1.0);
  CHECK(s.boundaries.x_min == BoundaryKind::periodic);
  CHECK(s.boundaries.y_min == BoundaryKind::open);
  CHECK(s.boundaries.y_max == BoundaryKind::wall);
  CHECK(s.time.mode == TimeMode::fixed);
  CHECK(s.time.step == 0.002);
  CHECK(s.time.subcycle);
  CHECK(s.time.minimum_step == 0.001);
  CHECK(s.numerics.scheme == Scheme::paper);
  CHECK(s.numerics.precision == Precision::float64);
  CHECK(s.numerics.momentum_flux == MomentumFlux::printed);
  CHECK_FALSE(s.numerics.rest_gate);
  CHECK(s.numerics.velocity == VelocityForm::quotient);
  CHECK(s.output.fields == std::vector{OutputField::surface, OutputField::momentum});
  CHECK_FALSE(s.output.frames);
  CHECK(s.output.maxima.value().above == 0.002);
  CHECK(s.output.maxima.value().pressure);
  CHECK(s.sand.density == 1500.0);
  REQUIRE(s.output.probes.size() == 1);
  CHECK(s.output.probes[0].name == "gate");
  CHECK(s.output.compression == Compression::gzip);
  CHECK(s.output.checkpoint_interval == 60.0);
  REQUIRE(s.reference);
  CHECK(s.reference->front_depths == std::vector{0.005, 0.05});
}

TEST_CASE("a missing file is said with the script that writes it") {
  const std::string scene =
      "made_by: make.py\ngrid: {cells: [2, 2], spacing: 1 m}\nterrain: {type: raster, file: missing.tif}\n"
      "sand: {friction_angle: 30 deg, initial: {type: layer, depth: 1 cm}}\ntime: {end: 1 s, frame_interval: 1 s}\n";
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "sandsim_made_by";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  const auto complaint = [&] {
    try {
      read_scene_text(scene, "s.yaml", folder);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("the scene was read");
  };
  const std::string script = (folder / "make.py").string();
  CHECK(complaint().find("s.yaml:3:") != std::string::npos);
  CHECK(complaint().find("made_by names the script that writes it, but " + script + " is missing, too.") !=
        std::string::npos);
  std::ofstream(folder / "make.py") << "\n";
  CHECK(complaint().find("Run " + script + ", which writes the files of this scene.") != std::string::npos);
  std::filesystem::remove_all(folder);
}

TEST_CASE("a scene whose files are there does not need the script that wrote them") {
  const std::string scene =
      "made_by: make.py\ngrid: {cells: [2, 2], spacing: 1 m}\n"
      "sand: {friction_angle: 30 deg, initial: {type: layer, depth: 1 cm}}\ntime: {end: 1 s, frame_interval: 1 s}\n";
  std::vector<std::string> warnings;
  const Scene s = read_scene_text(scene, "s.yaml", "no_such_folder", std::span<const std::string>{}, &warnings);
  CHECK(s.made_by->file == "make.py");
  CHECK(warnings.empty());
}

TEST_CASE("every kind of sand arrives in SI units") {
  const Sand sand = read(whole_scene).sand;
  CHECK_FALSE(sand.friction_angle);
  CHECK(std::get<RasterFile>(*sand.friction_coefficient).data->at(1, 0) == 95.0);
  CHECK(sand.hbar.policy == HbarPolicy::truncated);
  CHECK(std::get<double>(sand.hbar.scale) == 0.8);
  CHECK(std::get<RasterFile>(sand.hbar.cap).file == "data/angles.asc");
  REQUIRE(sand.initial.size() == 5);
  CHECK(std::get<SandBox>(sand.initial[0]).to == std::array{0.4, 1.0});
  CHECK(std::get<SandBox>(sand.initial[0]).fill.depth == 0.2);
  CHECK(std::get<SandBox>(sand.initial[0]).velocity == SandVelocity{10.0, -0.2});
  CHECK(std::get<SandColumn>(sand.initial[1]).velocity == SandVelocity{});
  CHECK(std::get<SandColumn>(sand.initial[1]).fill.surface == -0.01);
  CHECK_FALSE(std::get<SandColumn>(sand.initial[1]).fill.depth);
  CHECK(std::get<SandCone>(sand.initial[2]).height == 0.05);
  CHECK(std::get<SandLayer>(sand.initial[3]).fill.depth == 0.001);
  CHECK(std::get<SandRaster>(sand.initial[4]).file.data->values.size() == 4);
  REQUIRE(sand.sources.size() == 1);
  CHECK(sand.sources[0].rate == 0.002);
  CHECK(sand.sources[0].end == 120.0);
}

TEST_CASE("keys that are left out keep their defaults") {
  const Scene s = read(smallest_scene);
  CHECK(s.title.empty());
  CHECK(s.gravity == 9.8);
  CHECK(s.terrain.size() == 1);
  CHECK(s.sand.hbar.policy == HbarPolicy::full);
  CHECK_FALSE(s.time.courant);
  CHECK(s.numerics.order == 2);
  CHECK(s.output.fields == std::vector{OutputField::depth, OutputField::velocity});
  CHECK_FALSE(s.reference);
}

TEST_CASE("a map of angles holds the same value as an angle in the scene") {
  const std::string map =
      "grid: {cells: [20, 1], spacing: 1 cm}\ntime: {end: 1 s, frame_interval: 10 ms}\n"
      "sand: {friction_angle: {raster: data/slopes.asc, unit: deg}, initial: {type: layer, depth: 1 cm}}\n";
  const double angle = std::get<double>(*read(smallest_scene).sand.friction_angle);
  const Scene scene = read(map);
  CHECK(std::get<RasterFile>(*scene.sand.friction_angle).data->at(0, 1) == angle);
}

TEST_CASE("anchors and aliases may repeat values") {
  const Scene s = read(
      "grid: {cells: [20, 1], spacing: &d 1 cm}\n"
      "sand: {friction_angle: 30 deg, initial: {type: layer, depth: *d}}\n"
      "time: {end: 1 s, frame_interval: 10 ms}\n");
  CHECK(std::get<SandLayer>(s.sand.initial[0]).fill.depth == 0.01);
}

TEST_CASE("scenes may be written as JSON") {
  const Scene s = read(R"({"grid": {"cells": [20, 1], "spacing": "1 cm"},
    "sand": {"friction_angle": "30 deg", "initial": {"type": "layer", "depth": "1 cm"}},
    "time": {"end": "1 s", "frame_interval": "10 ms", "stop_at_rest": true}})");
  CHECK(s.time.stop_at_rest);
}

TEST_CASE("byte order marks and carriage returns do no harm") {
  std::string text = "\xEF\xBB\xBF";
  for (const char c : smallest_scene) text += c == '\n' ? "\r\n" : std::string(1, c);
  CHECK(read(text).time.end == 1.0);
}

TEST_CASE("a measured file that is missing is a warning and keeps its name") {
  std::vector<std::string> warnings;
  const Scene s = read(smallest_scene + "reference: {measured_profile: later.csv}\n", {}, &warnings);
  CHECK(s.reference->measured_profile->file == "later.csv");
  CHECK(s.reference->measured_profile->x.empty());
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].starts_with("s.yaml:4:13: reference.measured_profile = later.csv: the file is missing"));
}

TEST_CASE("the first row of a .npy is the southern one unless first_row says north") {
  const auto values = [](const std::string& first_row) {
    const Scene s = read(smallest_scene + "terrain: {type: raster, file: data/heights.npy" + first_row + "}\n");
    return std::get<RasterTerrain>(s.terrain[0]).file.data->values;  // from the south
  };
  const std::vector<double> as_stored{0.1, 0.2, 0.3, 0.4}, flipped{0.3, 0.4, 0.1, 0.2};
  CHECK(values("") == as_stored);
  CHECK(values(", first_row: south") == as_stored);
  CHECK(values(", first_row: north") == flipped);

  const Scene s = read(smallest_scene, {"sand.initial={type: raster, file: data/heights.npy, first_row: north}",
                                        "sand.friction_angle={first_row: north, raster: data/heights.npy, unit: deg}"});
  CHECK(std::get<SandRaster>(s.sand.initial[0]).file.data->values == flipped);
  CHECK_THAT(std::get<RasterFile>(*s.sand.friction_angle).data->values[0],
             Catch::Matchers::WithinRel(0.3 * M_PI / 180, 1e-15));
}

TEST_CASE("profiles and front curves are read") {
  const Scene s = read(smallest_scene + "reference: {profile: data/profile.csv, measured_front: data/front.csv}\n");
  CHECK(s.reference->profile->file == "data/profile.csv");
  CHECK(s.reference->profile->depth == std::vector{0.15, 0.0});
  CHECK(s.reference->measured_front->front == std::vector{0.4, 0.9});
}

TEST_CASE("a scene file that is missing or a folder is an input error") {
  CHECK_THROWS_AS(read_scene("no_such_scene.yaml"), InputError);
  CHECK_THROWS_AS(read_scene(SANDSIM_SOURCE_DIR "/tests"), InputError);
}

TEST_CASE("problems of the scene outweigh missing files in the exit code") {
  const std::string missing = "terrain: {type: raster, file: no.asc}\n";
  CHECK_THROWS_AS(read(smallest_scene + missing), InputError);
  CHECK_THROWS_AS(read(smallest_scene + missing + "gravity: 3\n"), SceneError);
}

TEST_CASE("a scene larger than 1 MiB is rejected unread") {
  CHECK(complaints(std::string((1U << 20) + 1, '#')).starts_with("s.yaml: larger than 1 MiB"));
}

TEST_CASE("hundreds of problems are cut to a screenful") {
  std::string text = smallest_scene;
  for (int k = 0; k < 300; ++k) text += "key" + std::to_string(k) + ": 1\n";
  const std::string message = complaints(text);
  CHECK(message.ends_with("... and 200 more problems."));
}
