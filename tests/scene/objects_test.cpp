#include <filesystem>
#include <fstream>
#include <numbers>

#include "solver/objects/distance_grid.hpp"
#include "solver/objects/mesh.hpp"
#include "solver/objects/object.hpp"
#include "tests/scene/support.hpp"
#include "tests/support/catch.hpp"

using namespace sandsim;
using namespace sandsim::test;

namespace {

const std::string objects_scene = smallest_scene + R"(
objects:
  - name: plough
    shape: {type: box, size: [1 cm, 20 mm, 0.5 m], position: [0 m, 0 m, 25 cm]}
    motion: {type: constant, velocity: [30 cm/s, 0 m/s, 0 m/s], angular_velocity: [0 rad/s, 0 rad/s, 60 rpm]}
    position: [10 cm, 0 m, 1 cells]
    rotation: {axis: [0, 0, 1], angle: 90 deg}
    coupling: drag
    vertical: printed
    start: 100 ms
    end: 0.5 s
  - name: pen
    shape: {type: brush, radius: 1 cm, height: 10 cm}
    motion: {type: stroke, points: [{time: 0 s, position: [5 cm, 0 m, 0 m]}, {time: 1 s, position: [9 cm, 0 m, 0 m]}]}
  - name: bead
    shape:
      type: csg
      operation: difference
      parts:
        - {type: sphere, radius: 2 cm}
        - {type: cylinder, radius: 1 cm, height: 5 cm, rotation: {euler: [90 deg, 0 deg, 0 deg]}}
    motion: {type: path, file: data/path.csv, interpolation: cubic}
    coupling: displace
)";

}  // namespace

TEST_CASE("every key of an object arrives in SI units") {
  const Scene s = read(objects_scene);
  REQUIRE(s.objects.size() == 3);
  const KinematicObject& plough = s.objects[0];
  CHECK(plough.name == "plough");
  CHECK(std::get<BoxShape>(plough.shape).size == std::array{0.01, 0.02, 0.5});
  CHECK(std::get<BoxShape>(plough.shape).placement.position[2] == 0.25);
  CHECK(std::get<ConstantMotion>(plough.motion).velocity[0] == 0.3);
  CHECK(std::get<ConstantMotion>(plough.motion).angular_velocity[2] == 60 * std::numbers::pi / 30);
  CHECK(plough.position == std::array{0.1, 0.0, 0.01});
  CHECK(plough.rotation.value().angle == 0.5 * std::numbers::pi);
  CHECK(plough.coupling == Coupling::drag);
  CHECK(plough.vertical == VerticalTransfer::printed);
  CHECK(plough.start == 0.1);
  CHECK(plough.end == 0.5);
  CHECK(std::get<Stroke>(s.objects[1].motion).points.at(1).position[0] == 0.09);
  CHECK(s.objects[1].coupling == Coupling::displace);
  const CsgShape& bead = std::get<CsgShape>(s.objects[2].shape);
  CHECK(bead.operation == SetOperation::subtract);
  CHECK(std::get<SphereShape>(bead.parts.at(0)).radius == 0.02);
  CHECK(std::get<Path>(s.objects[2].motion).file.position.at(1)[2] == -0.01);
  CHECK(std::get<Path>(s.objects[2].motion).interpolation == objects::Interpolation::cubic);
}

TEST_CASE("an object without a motion is fixed and upright") {
  const Scene s = read(smallest_scene, {"objects=[{name: a, shape: {type: sphere, radius: 1 cm}}]"});
  CHECK(std::holds_alternative<FixedMotion>(s.objects.at(0).motion));
  CHECK_FALSE(s.objects[0].rotation);
  CHECK_FALSE(s.objects[0].end);
}

TEST_CASE("the files of meshes and signed distances are read with the scene") {
  const Scene s =
      read(smallest_scene, {"objects=[{name: a, shape: {type: mesh, file: data/tetrahedron.obj, unit: cm}},"
                            "{name: b, shape: {type: sdf, file: data/cross.npy, spacing: 1 cm, "
                            "origin: [0 m, 0 m, -1 cm]}, position: [5 mm, -5 mm, 0 m], sample_spacing: 1 mm}]"});
  const MeshShape& mesh = std::get<MeshShape>(s.objects.at(0).shape);
  CHECK(mesh.file.mesh->triangles.size() == 4);
  CHECK(mesh.unit == MeshUnit::cm);
  CHECK(mesh.file.distance == nullptr);
  CHECK(std::get<SdfShape>(s.objects.at(1).shape).file.distance->points == std::array{3, 3, 3});
  // 1 cm of mesh lies between z = 0 and 1 cm, and the sample in the middle of the array is 1 cm from each side.
  const objects::Object tetrahedron(s.objects[0], s.grid.spacing);
  const auto column = [](const objects::Object& o, double x, double y) {
    return objects::inside_column(o.shape(), o.at(0).pose, x, y, {-1, 1}, o.sample_spacing());
  };
  REQUIRE(column(tetrahedron, 0.002, 0.003).count == 1);
  // The edges are a hundred samples away from the sharp corners' own size; 1e-4 m is one sample.
  CHECK_THAT(column(tetrahedron, 0.002, 0.003).items[0].to, WithinAbs(0.005, 1e-4));
  const objects::Object cross(s.objects[1], s.grid.spacing);
  REQUIRE(column(cross, 0.015, 0.005).count == 1);
}

namespace {

/// A cube of 4 cm about the origin as OBJ, and what reading a scene with it warns about.
std::string box_text(bool is_inside_out, double x) {
  std::string text;
  for (int k = 0; k < 8; ++k) {
    text += "v " + std::to_string((k % 2 - 0.5) * x) + " " + std::to_string((k / 2 % 2 - 0.5) * 4) + " " +
            std::to_string((k / 4 - 0.5) * 4) + "\n";
  }
  for (const std::string face : {"1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6"}) {
    text += "f " + (is_inside_out ? std::string(face.rbegin(), face.rend()) : face) + "\n";
  }
  return text;
}

std::vector<std::string> warnings_of(const std::filesystem::path& file, const std::string& content,
                                     const std::string& shape, const std::string& more = "", Scene* scene = nullptr) {
  std::ofstream(file) << content;
  std::vector<std::string> warnings;
  const Scene s = read(smallest_scene + "objects:\n  - {name: a, position: [10 cm, 0 m, 0 m], shape: {" + shape +
                           ", file: " + file.string() + "}" + more + "}\n",
                       {}, &warnings);
  if (scene != nullptr) *scene = s;
  std::filesystem::remove(file);
  return warnings;
}

}  // namespace

TEST_CASE("a mesh that is inside out is turned with a warning that names its place") {
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "sandsim_inside_out.obj";
  CHECK(warnings_of(file, box_text(false, 4), "type: mesh, unit: cm").empty());
  const std::vector<std::string> warnings = warnings_of(file, box_text(true, 4), "type: mesh, unit: cm");
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].starts_with("s.yaml:5:"));
  CHECK(warnings[0].find("the mesh is inside out (12 of 12 triangles are turned round)") != std::string::npos);
}

TEST_CASE("what is odd about a mesh's file is said") {
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "sandsim_odd.obj";
  const auto warnings = warnings_of(file, box_text(false, 4) + "f 1 2\n", "type: mesh, unit: cm");
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].find(".obj:15:1: a face with fewer than three corners is left out") != std::string::npos);
}

TEST_CASE("a moving object that is thin is warned about and a fixed one without effect is refused") {
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "sandsim_thin.obj";
  const std::string moves = ", motion: {type: constant, velocity: [1 cm/s, 0 m/s, 0 m/s]}";
  const auto warnings = warnings_of(file, box_text(false, 0.01), "type: mesh, unit: cm", moves);
  REQUIRE(warnings.size() == 2);
  CHECK(warnings[0].find("narrower than a cell") != std::string::npos);
  CHECK(warnings[1].find("thinner than its samples are apart") != std::string::npos);
  const std::string wall = "objects=[{name: a, shape: {type: box, size: [9 mm, 1 m, 1 m]}, position: [";
  CHECK(complaints(smallest_scene, {wall + "10.4 cm, 0 m, 0 m]}]"}).empty());
  CHECK(complaints(smallest_scene, {wall + "10 cm, 0 m, 0 m]}]"}).find("it covers no centre of a cell") !=
        std::string::npos);
}

TEST_CASE("distances that are negative all round their border are turned or refused") {
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "sandsim_sign.sdf";
  const auto text = [](const std::string& rim, const std::string& middle, const std::string& corner) {
    std::string result = "3 3 3 -0.02 -0.02 -0.02 0.02 " + corner;
    for (int k = 1; k < 27; ++k) result += " " + (k == 13 ? middle : rim);
    return result;
  };
  Scene turned;
  CHECK(warnings_of(file, text("0.02", "-0.02", "0.02"), "type: sdf").empty());
  const auto warnings = warnings_of(file, text("-0.02", "0.02", "0"), "type: sdf", "", &turned);
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].find("Their sign is turned.") != std::string::npos);
  const auto& grid = *std::get<SdfShape>(turned.objects.at(0).shape).file.distance;
  CHECK(grid.values[13] == -0.02F);
  CHECK(grid.values[1] == 0.02F);
  // One sample of the border is outside: the object may be cut by its box.
  const auto kept = warnings_of(file, text("-0.02", "0.02", "0.02"), "type: sdf", "", &turned);
  REQUIRE(kept.size() == 1);
  CHECK(kept[0].find("25 of 26 are negative") != std::string::npos);
  CHECK(std::get<SdfShape>(turned.objects.at(0).shape).file.distance->values[13] == 0.02F);
  CHECK_THROWS_AS(warnings_of(file, text("-0.02", "-0.02", "0"), "type: sdf"), SceneError);
  std::filesystem::remove(file);
}

TEST_CASE("an object may leave the grid but not start outside it") {
  const std::string object = "objects=[{name: a, shape: {type: sphere, radius: 1 cm}, ";
  CHECK(complaints(smallest_scene, {object + "position: [10 cm, 9 m, 0 m], "
                                             "motion: {type: constant, velocity: [9 m/s, 0 m/s, 0 m/s]}}]"})
            .empty());
  CHECK_FALSE(complaints(smallest_scene, {object + "position: [-10 cm, 0 m, 0 m]}]"}).empty());
  // At its start it is where its first keyframe has it.
  CHECK_FALSE(complaints(smallest_scene, {object + "motion: {type: keyframes, keyframes: "
                                                   "[{time: 0 s, position: [9 m, 0 m, 0 m]}]}}]"})
                  .empty());
}

TEST_CASE("numbers at the ends of double precision give directions") {
  const std::string object = "objects=[{name: a, shape: {type: sphere, radius: 1 cm}, rotation: ";
  CHECK(complaints(smallest_scene, {object + "{quaternion: [1e-300, 0, 0, 1e-300]}}]"}).empty());
  CHECK(complaints(smallest_scene, {object + "{axis: [1e300, 1e300, 0], angle: 9 deg}}]"}).empty());
}
