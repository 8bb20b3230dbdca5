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
  const Scene s = read(smallest_scene, {"objects=[{name: a, shape: {type: mesh, file: data/tetrahedron.obj, unit: cm}},"
                                        "{name: b, shape: {type: sdf, file: data/cross.npy, spacing: 1 cm, "
                                        "origin: [0 m, 0 m, -1 cm]}, sample_spacing: 1 mm}]"});
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
  REQUIRE(column(cross, 0.01, 0.01).count == 1);
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
