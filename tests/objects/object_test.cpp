#include "solver/objects/object.hpp"

#include <numbers>

#include "tests/objects/support.hpp"

using namespace sandsim;
using namespace sandsim::objects;
using namespace sandsim::test;
using sandsim::KinematicObject;

namespace {

constexpr double pi = std::numbers::pi;

/// An object of this shape and motion at the origin.
KinematicObject object(const ObjectShape& shape, const ObjectMotion& motion = FixedMotion{}) {
  KinematicObject result;
  result.name = "a";
  result.shape = shape;
  result.motion = motion;
  return result;
}

Rotation about_z(double angle) {
  Rotation rotation;
  rotation.axis = {0, 0, 2};
  rotation.angle = angle;
  return rotation;
}

Interval column(const Object& o, double time, double x, double y) {
  const Intervals found = inside_column(o.shape(), o.at(time).pose, x, y, {-endless, endless}, o.sample_spacing());
  return found.count == 1 ? found.items[0] : Interval{};
}

}  // namespace

TEST_CASE("sizes of the scene are whole lengths") {
  const Object box(object(BoxShape{{1, 2, 3}, {}}), 0.1);
  CHECK(column(box, 0, 0, 0.9).to == 1.5);
  CHECK(column(box, 0, 0, 1.1).empty());
  const Object capsule(object(CapsuleShape{1, 4, {}}), 0.1);
  CHECK(column(capsule, 0, 0, 0).to == 2.0);
  const Object cylinder(object(CylinderShape{1, 4, {}}), 0.1);
  CHECK(column(cylinder, 0, 0, 0).from == -2.0);
  const Object cone(object(ConeShape{1, 4, {}}), 0.1);
  CHECK(column(cone, 0, 0, 0).to == 2.0);
  const Object brush(object(BrushShape{1, 4, {}}), 0.1);
  CHECK(column(brush, 0, 0, 0).from == 0.0);
  CHECK(column(brush, 0, 0, 0).to == 4.0);
}

TEST_CASE("a shape's place in its object and the object's in the scene add up") {
  KinematicObject o = object(SphereShape{1, {{2, 0, 0}, {}}}, Spin{{0, 0, 5}, 2 * pi, {}});
  o.position = {10, 0, 3};
  const Object placed(o, 0.1);
  // After a quarter of a turn the sphere is at (10, 2, 3).
  CHECK_THAT(column(placed, 0.25, 10, 2).to, WithinAbs(4.0, 1e-12));
  CHECK_THAT(placed.bounds(placed.at(0.25)).high.y, WithinAbs(3.0, 1e-12));
  // The point farthest from the axis, 3 m, bounded by the corner of the box around the sphere.
  CHECK(placed.top_speed(placed.at(0.25)) >= 2 * pi * 3);
  CHECK(placed.top_speed(placed.at(0.25)) <= 2 * pi * std::sqrt(11.0) + 1e-12);
}

TEST_CASE("turning an object by its motion equals turning its shape") {
  KinematicObject turned = object(BoxShape{{1, 2, 3}, {}});
  turned.rotation = about_z(0.7);
  KinematicObject shape_turned = object(BoxShape{{1, 2, 3}, {{}, about_z(0.7)}});
  KinematicObject moved = object(BoxShape{{1, 2, 3}, {}}, ConstantMotion{{}, {0, 0, 0.7}});
  Random random;
  for (int k = 0; k < 100; ++k) {
    const Vec3 p = random.vector(1.5);
    const Interval expected = column(Object(turned, 1), 0, p.x, p.y);
    for (const Interval& found :
         {column(Object(shape_turned, 1), 0, p.x, p.y), column(Object(moved, 1), 1, p.x, p.y)}) {
      CHECK_THAT(found.from, WithinAbs(expected.from, 1e-12));
      CHECK_THAT(found.to, WithinAbs(expected.to, 1e-12));
    }
  }
}

TEST_CASE("a path and keyframes and a stroke through the same points are the same motion") {
  const std::vector<std::array<double, 3>> points{{0, 0, 0}, {1, 0, 2}, {1, 3, 0}};
  const std::vector<double> times{0, 1, 3};
  Keyframes keyframes;
  Stroke stroke;
  for (std::size_t k = 0; k < 3; ++k) {
    keyframes.keyframes.push_back({times[k], points[k], about_z(0.3)});
    stroke.points.push_back({times[k], points[k]});
  }
  KinematicObject along_path = object(SphereShape{1, {}}, Path{{"", times, points}, Interpolation::linear});
  KinematicObject along_stroke = object(SphereShape{1, {}}, stroke);
  along_path.rotation = along_stroke.rotation = about_z(0.3);
  const Object expected(object(SphereShape{1, {}}, keyframes), 1);
  for (const KinematicObject& o : {along_path, along_stroke}) {
    for (double t = 0; t < 3.5; t += 0.1) {
      const RigidState a = expected.at(t);
      const RigidState b = Object(o, 1).at(t);
      CHECK(difference(a.pose.position, b.pose.position) < 1e-12);
      CHECK(difference(a.velocity, b.velocity) < 1e-12);
      CHECK(difference(a.pose.orientation, b.pose.orientation) < 1e-12);
    }
  }
}

TEST_CASE("an object is there from its start until its end and moves from its start on") {
  KinematicObject o = object(SphereShape{1, {}}, ConstantMotion{{2, 0, 0}, {}});
  o.start = 1;
  o.end = 3;
  const Object late(o, 0.1);
  CHECK_FALSE(late.is_present(0.9));
  CHECK(late.is_present(1));
  CHECK_FALSE(late.is_present(3));
  CHECK(late.at(1).pose.position.x == 0.0);
  CHECK(late.at(2).pose.position.x == 2.0);
  CHECK(Object(object(SphereShape{1, {}}), 1).is_present(1e9));
}

TEST_CASE("an intersection and a difference follow the order of their parts") {
  const std::vector<PrimitiveShape> parts{BoxShape{{4, 4, 4}, {}}, SphereShape{1, {}}, SphereShape{1, {{0, 0, 2}, {}}}};
  const Object difference_of(object(CsgShape{SetOperation::subtract, parts, {}}), 1);
  const Intervals found = inside_column(difference_of.shape(), difference_of.at(0).pose, 0, 0, {-endless, endless}, 1);
  REQUIRE(found.count == 1);
  CHECK(found.items[0].from == -2.0);
  CHECK(found.items[0].to == -1.0);
  const Object shared(object(CsgShape{SetOperation::intersect, {parts[0], parts[1]}, {{5, 0, 0}, {}}}), 1);
  CHECK(column(shared, 0, 5, 0).to == 1.0);
}

TEST_CASE("samples are a cell apart unless the scene says otherwise") {
  KinematicObject o = object(SphereShape{1, {}});
  CHECK(Object(o, 0.25).sample_spacing() == 0.25);
}
