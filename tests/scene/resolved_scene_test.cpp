#include "io/scene/resolved_scene.hpp"

#include <filesystem>

#include "tests/scene/support.hpp"
#include "tests/support/catch.hpp"

using namespace sandsim;
using namespace sandsim::test;

namespace {

const std::vector<std::vector<std::string>> variations = {
    {},
    {"title='quotes \" and \\ and # and: ü'"},
    {"grid.spacing=0.1 mm", "gravity=0.3333333333333333 m/s^2"},
    {"sand.hbar={policy: constant, depth: 7 cells}"},
    {"sand.hbar={policy: scaled, scale: 0.1}"},
    {"sand.hbar={policy: truncated, scale: {raster: data/fractions.asc}, cap: {raster: data/angles.asc, unit: m}}"},
    {"sand.friction_angle={raster: data/slopes.asc, unit: deg}"},
    {"sand.friction_angle=", "sand.friction_coefficient=0.1"},
    {"sand.sources=[{center: [1 cm, 0 m], radius: 1 mm, rate: 3 cm^3/s, end: 1 min}]"},
    {"sand.initial=[]", "sand.sources=[{center: [1 cm, 0 m], radius: 1 mm, rate: 3 l/s, end: 1 h}]"},
    {"sand.initial=[{type: cone, center: [3 mm, 1 cm], radius: 3 cm, height: 1 mm}, {type: layer, surface: -0 m}]"},
    {"sand.initial={type: raster, file: data/fractions.asc}"},
    {"sand.initial={type: raster, file: data/heights.npy, first_row: north}"},
    {"terrain={type: raster, file: data/heights.npy, first_row: south, scale: 2}"},
    {"sand.hbar={policy: scaled, scale: {raster: data/heights.npy, first_row: north}}"},
    {"sand.hbar={policy: truncated, scale: 0.1, cap: {raster: data/heights.npy, unit: m, first_row: north}}"},
    {"sand.initial={type: layer, depth: 1 mm, velocity: [0.1 m/s, 0 m/s]}"},
    {"terrain={type: plane, inclination: 12.3 deg, direction: 180 deg}"},
    {"terrain=[{type: flat}, {type: raster, file: data/angles.asc, offset: -0.1 m}]"},
    {"boundaries={x_min: periodic, x_max: periodic, y_min: open, y_max: open}"},
    {"time={mode: fixed, step: 0.3 ms, end: 7 min, frame_interval: 3 ms, minimum_step: 1e-9 s}"},
    {"time.courant=0.3", "time.stop_at_rest=true"},
    {"numerics={scheme: paper, momentum_flux: printed, rest_gate: false, velocity: quotient, precision: float64}"},
    {"output={fields: [momentum], maxima: {above: 3 mm}, probes: [{name: 'a b', at: [1 mm, 0 m]}]}"},
    {"reference={}"},
    {"reference={exact: {type: dam_break, dam: 7 cm, depth: 3 cm}, front_depths: 1 mm, profile: data/profile.csv}"},
    {"reference={measured_profile: later.csv, measured_front: data/front.csv}"},
    {"objects=[{name: a, shape: {type: sphere, radius: 1 cm}, position: [3 cm, 0 m, 1 cells], coupling: solid}]"},
    {"objects=[{name: a, shape: {type: box, size: [1 cm, 2 cm, 3 cm], rotation: {euler: [1 deg, 2 deg, 3 deg]}}, "
     "position: [3 cm, 0 m, 0 m], coupling: drag, vertical: printed, start: 0.1 s, end: 0.3 s}]"},
    {"objects=[{name: a, shape: {type: csg, operation: difference, parts: [{type: half_space, normal: [1, 2, 3]}, "
     "{type: brush, radius: 1 cm, height: 0.1 m, position: [1 mm, 2 mm, 3 mm]}]}, "
     "rotation: {axis: [1, 0, 2], angle: 7 deg}, motion: {type: spin, rate: 7 rpm, center: [0 m, 0 m, 1 m]}}]"},
    {"objects=[{name: a, shape: {type: capsule, radius: 1 cm, length: 9 cm}, motion: {type: keyframes, interpolation: "
     "cubic, keyframes: [{time: 0 s, position: [3 cm, 0 m, 0 m], rotation: {quaternion: [1, 2, 3, 4]}}]}}]"},
    {"objects=[{name: a, shape: {type: ellipsoid, radii: [1 cm, 2 cm, 1 m]}, motion: {type: path, file: "
     "data/path.csv}},"
     " {name: b, shape: {type: cone, radius: 1 cm, height: 1 m}, motion: {type: constant, velocity: [7 km/h, 0 m/s, "
     "0 m/s], angular_velocity: [0 rad/s, 3 deg/s, 7 rpm]}}]"},
    {"objects=[{name: a, shape: {type: mesh, file: data/tetrahedron.obj, unit: in, scale: 0.1, resolution: 50}, "
     "position: [4 mm, 4 mm, 0 m], sample_spacing: 1 mm}]"},
    {"objects=[{name: a, shape: {type: sdf, file: data/cross.sdf, scale: 0.01}, position: [5 mm, 5 mm, 0 m]}, {name: "
     "b, shape: {type: sdf, file: "
     "data/cross.npy, spacing: 1 mm, origin: [1 cm, 0 m, 0 m]}, position: [-6 mm, 4 mm, 0 m], sample_spacing: 1 mm}]"},
    {"objects=[{name: a, shape: {type: cylinder, radius: 1 cm, height: 3 mm}, motion: {type: stroke, points: [{time: "
     "0 s, position: [3 cm, 0 m, 0 m]}, {time: 7 ms, position: [7 cm, 0 m, 0 m]}]}}]"},
};

}  // namespace

TEST_CASE("the resolved scene reads back to itself") {
  // Numbers are written in the shortest form that gives the same bits, so that equal text means equal bits.
  for (const std::vector<std::string>& overrides : variations) {
    const std::string resolved = resolved_scene(read(smallest_scene, overrides));
    CAPTURE(resolved);
    CHECK(resolved_scene(read(resolved)) == resolved);
  }
}

TEST_CASE("the resolved scene keeps values that have no short decimal form") {
  Scene scene = read(smallest_scene);
  scene.gravity = 0.1 + 0.2;
  scene.grid.origin = {-0.0, 1e-300};
  const Scene again = read(resolved_scene(scene));
  CHECK(again.gravity == 0.1 + 0.2);
  CHECK(std::signbit(again.grid.origin[0]));
  CHECK(again.grid.origin[1] == 1e-300);
  CHECK(std::get<double>(*again.sand.friction_angle) == std::get<double>(*scene.sand.friction_angle));
}

TEST_CASE("the resolved scene shows defaults and hides what does not apply") {
  const std::string resolved = resolved_scene(read(smallest_scene));
  CHECK(resolved.find("checkpoint_interval: 600 s\n") != std::string::npos);
  CHECK(resolved.find("policy: full\n") != std::string::npos);
  CHECK(resolved.find("cap:") == std::string::npos);
  CHECK(resolved.find("momentum_flux") == std::string::npos);
  CHECK(resolved.find("reference") == std::string::npos);
}

TEST_CASE("file names can be moved into a folder") {
  const Scene scene = read(smallest_scene, {"terrain={type: raster, file: data/angles.asc}",
                                            "reference.profile=../bad_scenes/data/profile.csv"});
  const std::string resolved = resolved_scene(scene, "/somewhere");
  CHECK(resolved.find("file: \"/somewhere/data/angles.asc\"") != std::string::npos);
  CHECK(resolved.find("profile: \"/bad_scenes/data/profile.csv\"") != std::string::npos);
}

TEST_CASE("every scene that ships reads and resolves to itself") {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(SANDSIM_SOURCE_DIR "/scenes")) {
    // Beside the scenes there are files that describe studies and sweeps of them.
    if (entry.path().extension() != ".yaml" || !entry.path().filename().string().starts_with("scene")) continue;
    CAPTURE(entry.path());
    const std::string resolved = resolved_scene(read_scene(entry.path()));
    CHECK(resolved_scene(read_scene_text(resolved, "resolved", entry.path().parent_path())) == resolved);
    ++count;
  }
  CHECK(count > 0);
}
