#include "solver/objects/inspection.hpp"

#include <memory>
#include <numbers>

#include "solver/objects/distance_grid.hpp"
#include "tests/objects/meshes.hpp"
#include "tests/objects/support.hpp"

using namespace sandsim;
using namespace sandsim::objects;
using namespace sandsim::test;

namespace {

Scene scene_of(const ObjectShape& shape, const std::array<double, 3>& position) {
  Scene scene;
  scene.grid.cells = {10, 10};
  scene.grid.spacing = 1.0;
  KinematicObject object;
  object.name = "a";
  object.shape = shape;
  object.position = position;
  scene.objects = {object};
  return scene;
}

std::size_t covered(const Scene& scene) {
  return covered_cells(scene.objects[0], scene.grid);
}

MeshShape mesh_of(const TriangleMesh& mesh) {
  return {{"a.obj", std::make_shared<TriangleMesh>(mesh), nullptr}, MeshUnit::cm, 100.0, 32, {}};
}

Rotation about_z(double degrees) {
  return {{{0, 0, 1}}, degrees * std::numbers::pi / 180.0, {}, {}};
}

}  // namespace

TEST_CASE("an object covers the cells whose centres lie in its footprint") {
  // 3.2 m from 3.4 m on, and 2 m from 2 m on: the centres 3.5 to 6.5 and 2.5, 3.5.
  CHECK(covered(scene_of(BoxShape{{3.2, 2, 1}, {}}, {5, 3, 7})) == 8);
  CHECK(covered(scene_of(mesh_of(box_mesh({3.2, 2, 1})), {5, 3, 7})) == 8);
  // From one end of the grid to beyond the other.
  CHECK(covered(scene_of(BoxShape{{100, 1, 1}, {}}, {0, 2.5, 0})) == 10);
  CHECK(covered(scene_of(mesh_of(box_mesh({100, 1, 1})), {0, 2.5, 0})) == 10);
  // Between two centres.
  CHECK(covered(scene_of(BoxShape{{0.9, 9, 1}, {}}, {5, 5, 0})) == 0);
  CHECK(covered(scene_of(mesh_of(box_mesh({0.9, 9, 1})), {5, 5, 0})) == 0);
}

TEST_CASE("a footprint is as wide as the narrower side of its box, however that is turned") {
  const Scene upright = scene_of(BoxShape{{0.3, 4, 1}, {}}, {5, 5, 0});
  CHECK_THAT(narrowest_width(upright.objects[0], upright.grid), WithinRel(0.3, 1e-14));
  const Scene turned = scene_of(BoxShape{{0.3, 4, 1}, {{}, about_z(30)}}, {5, 5, 0});
  CHECK_THAT(narrowest_width(turned.objects[0], turned.grid), WithinRel(0.3, 1e-14));
  // A plate that lies flat is wide.
  const Scene flat = scene_of(BoxShape{{3, 4, 0.1}, {}}, {5, 5, 0});
  CHECK_THAT(narrowest_width(flat.objects[0], flat.grid), WithinRel(3.0, 1e-14));
}

TEST_CASE("volumes of shapes are theirs") {
  CHECK_THAT(volume(BoxShape{{0.3, 4, 2}, {{1, 2, 3}, about_z(30)}}).value(), WithinRel(2.4, 1e-12));
  CHECK_THAT(volume(mesh_of(box_mesh({0.3, 4, 2}))).value(), WithinRel(2.4, 1e-12));
  // Columns of a hundredth of the box: its rim is right to 1 %.
  CHECK_THAT(volume(SphereShape{1.0, {}}).value(), WithinRel(4.0 / 3.0 * std::numbers::pi, 1e-2));
  CHECK_FALSE(volume(HalfSpaceShape{}).has_value());
  TriangleMesh open = box_mesh({1, 1, 1});
  open.triangles.pop_back();
  CHECK_FALSE(volume(mesh_of(open)).has_value());
}

TEST_CASE("objects narrower than a cell or thinner than their samples are found") {
  CHECK(thin_objects(scene_of(BoxShape{{1, 4, 0.1}, {}}, {5, 5, 0})).empty());
  CHECK(thin_objects(scene_of(BoxShape{{0.9, 4, 2}, {}}, {5, 5, 0})).size() == 1);
  CHECK(thin_objects(scene_of(mesh_of(box_mesh({4, 4, 2})), {5, 5, 0})).empty());
  // 4 m with 32 - 5 spacings of samples: 15 cm. The plate lies flat, so that only its samples miss it.
  CHECK(thin_objects(scene_of(mesh_of(box_mesh({4, 4, 0.2})), {5, 5, 0})).empty());
  const auto issues = thin_objects(scene_of(mesh_of(box_mesh({4, 4, 0.1})), {5, 5, 0}));
  REQUIRE(issues.size() == 1);
  CHECK(issues[0].key == "objects.0.shape.file");
  DistanceGrid grid{{3, 3, 3}, {}, 1.0, std::vector<float>(27, 1.0F)};
  grid.values[13] = -0.4F;
  const auto sdf = [&] { return SdfShape{{"a.sdf", std::make_shared<DistanceGrid>(grid)}, {}, {}, 1.0, {}}; };
  CHECK(thin_objects(scene_of(sdf(), {4, 4, 0})).size() == 1);
  grid.values[13] = -0.6F;
  CHECK(thin_objects(scene_of(sdf(), {4, 4, 0})).empty());
}
