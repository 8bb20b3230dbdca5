#include "solver/objects/primitive.hpp"

#include <vector>

#include "solver/objects/bounds.hpp"
#include "solver/objects/distance.hpp"
#include "tests/objects/support.hpp"

using namespace sandsim::objects;
using namespace sandsim::test;

namespace {

constexpr double half_root = 0.70710678118654752440;

/// One of each kind, about 1 m large.
const std::vector<Primitive> one_of_each{
    {PrimitiveKind::sphere, {0.8, 0, 0}, {}},       {PrimitiveKind::box, {0.3, 0.5, 0.9}, {}},
    {PrimitiveKind::capsule, {0.4, 0.5, 0}, {}},    {PrimitiveKind::cylinder, {0.7, 0.4, 0}, {}},
    {PrimitiveKind::cone, {0.8, 0.6, 0}, {}},       {PrimitiveKind::ellipsoid, {0.9, 0.3, 0.6}, {}},
    {PrimitiveKind::half_space, {0.6, 0, 0.8}, {}}, {PrimitiveKind::brush, {0.2, 1.2, 0}, {}},
};

Primitive primitive(PrimitiveKind kind, const Vec3& size) {
  return {kind, size, {}};
}

Interval vertical(const Primitive& p, double x, double y) {
  return inside(p, {{x, y, 0}, {0, 0, 1}});
}

void check_interval(const Interval& found, double from, double to) {
  // Coordinates of about 1 and a few operations.
  CHECK_THAT(found.from, WithinAbs(from, 1e-14));
  CHECK_THAT(found.to, WithinAbs(to, 1e-14));
}

}  // namespace

TEST_CASE("vertical lines are inside primitives where geometry says") {
  check_interval(vertical(primitive(PrimitiveKind::sphere, {5, 0, 0}), 3, 0), -4, 4);
  check_interval(vertical(primitive(PrimitiveKind::box, {1, 2, 3}), 0.5, -1.5), -3, 3);
  check_interval(vertical(primitive(PrimitiveKind::capsule, {5, 1, 0}), 0, 3), -5, 5);
  check_interval(vertical(primitive(PrimitiveKind::cylinder, {1, 2, 0}), 0.5, 0.5), -2, 2);
  check_interval(vertical(primitive(PrimitiveKind::cone, {2, 1, 0}), 0, 0), -1, 1);
  check_interval(vertical(primitive(PrimitiveKind::cone, {2, 1, 0}), 1, 0), -1, 0);
  check_interval(vertical(primitive(PrimitiveKind::ellipsoid, {5, 1, 10}), 3, 0), -8, 8);
  check_interval(vertical(primitive(PrimitiveKind::half_space, {0, 0, 1}), 7, 7), -endless, 0);
  check_interval(vertical(primitive(PrimitiveKind::half_space, {-0.6, 0, -0.8}), 4, 0), -3, endless);
  check_interval(vertical(primitive(PrimitiveKind::brush, {1, 3, 0}), 0, 0), 0, 3);
}

TEST_CASE("horizontal lines are inside primitives where geometry says") {
  const Line line{{0, 0, 0.5}, {2, 0, 0}};
  check_interval(inside(primitive(PrimitiveKind::cone, {2, 1, 0}), line), -0.25, 0.25);
  check_interval(inside(primitive(PrimitiveKind::capsule, {1, 1, 0}), line), -0.5, 0.5);
  CHECK(inside(primitive(PrimitiveKind::half_space, {0, 0, 1}), line).empty());
  CHECK(inside(primitive(PrimitiveKind::cylinder, {1, 0.4, 0}), line).empty());
}

TEST_CASE("lines along a cone's slant and through its tip are handled") {
  const Primitive cone = primitive(PrimitiveKind::cone, {2, 1, 0});
  // Parallel to one slant: |x| < 1 - z holds along (t, -t) for t > -1/2, and the base ends it.
  check_interval(inside(cone, {{0, 0, 0}, {1, 0, -1}}), -0.5, 1.0);
  CHECK(inside(cone, {{0, 0, 1}, {1, 0, 0}}).empty());
  CHECK(inside(cone, {{0, 0, 1}, {1, 0, 1}}).empty());
  // Steeper than the slant, which is 45 deg, and through the tip: inside below it.
  check_interval(inside(cone, {{0, 0, 1}, {0.5, 0, 1}}), -2, 0);
}

TEST_CASE("lines that miss or touch are nowhere inside") {
  CHECK(vertical(primitive(PrimitiveKind::sphere, {1, 0, 0}), 1, 0).empty());
  CHECK(vertical(primitive(PrimitiveKind::box, {1, 1, 1}), 1, 0).empty());
  CHECK(vertical(primitive(PrimitiveKind::capsule, {1, 1, 0}), 0.8, 0.8).empty());
  CHECK(vertical(primitive(PrimitiveKind::cylinder, {1, 1, 0}), 0, 1).empty());
  CHECK(vertical(primitive(PrimitiveKind::cone, {1, 1, 0}), 1, 0).empty());
  CHECK(vertical(primitive(PrimitiveKind::ellipsoid, {1, 2, 3}), 0, 2).empty());
}

TEST_CASE("the ends of every interval lie on the surface and its middle inside") {
  Random random;
  for (const Primitive& own : one_of_each) {
    int hits = 0;
    for (int k = 0; k < 2000; ++k) {
      Primitive p = own;
      p.pose = random.pose(1.0);
      const Line line{random.vector(1.5), random.vector(1.0)};
      const Interval found = inside(p, line);
      const auto distance_at = [&](double t) { return distance(p, line.origin + t * line.direction); };
      CAPTURE(static_cast<int>(p.kind), k, found.from, found.to);
      if (found.empty()) {
        for (double t = -4; t < 4; t += 0.25) CHECK(distance_at(t) > -1e-12);
        continue;
      }
      ++hits;
      // Rounding of coordinates of about 5, enlarged where the line grazes the surface: the root of its square.
      if (found.from > -endless) CHECK_THAT(distance_at(found.from), WithinAbs(0.0, 1e-12));
      if (found.to < endless) CHECK_THAT(distance_at(found.to), WithinAbs(0.0, 1e-12));
      const double from = std::fmax(found.from, -10.0);
      const double to = std::fmin(found.to, 10.0);
      if (to - from > 1e-6) CHECK(distance_at(0.5 * (from + to)) < 0.0);
      if (found.from > -endless) CHECK(distance_at(found.from - 1e-3) > 0.0);
      if (found.to < endless) CHECK(distance_at(found.to + 1e-3) > 0.0);
    }
    CHECK(hits > 50);
  }
}

TEST_CASE("distances are those of geometry") {
  const auto distance_to = [](PrimitiveKind kind, const Vec3& size, const Vec3& point) {
    return distance_own_frame(primitive(kind, size), point);
  };
  CHECK(distance_to(PrimitiveKind::sphere, {1, 0, 0}, {0, 3, 4}) == 4.0);
  CHECK(distance_to(PrimitiveKind::box, {1, 2, 3}, {0.5, 0, 0}) == -0.5);
  CHECK(distance_to(PrimitiveKind::box, {1, 2, 3}, {4, 6, 0}) == 5.0);
  CHECK(distance_to(PrimitiveKind::capsule, {1, 2, 0}, {3, 0, 6}) == 4.0);
  CHECK(distance_to(PrimitiveKind::cylinder, {1, 2, 0}, {4, 0, 6}) == 5.0);
  CHECK(distance_to(PrimitiveKind::cylinder, {1, 2, 0}, {0, 0, 1.5}) == -0.5);
  CHECK(distance_to(PrimitiveKind::cone, {3, 2, 0}, {0, 0, 5}) == 3.0);
  CHECK(distance_to(PrimitiveKind::cone, {3, 2, 0}, {6, 0, -6}) == 5.0);
  // From the axis at the base's height 2 above it: 0.6 of the way to the slant's foot.
  CHECK_THAT(distance_to(PrimitiveKind::cone, {3, 2, 0}, {0, 0, 0}), WithinAbs(-1.2, 1e-15));
  CHECK_THAT(distance_to(PrimitiveKind::half_space, {0.6, 0, 0.8}, {5, 9, -5}), WithinAbs(-1.0, 1e-15));
  CHECK(distance_to(PrimitiveKind::brush, {1, 2, 0}, {0, 0, -1}) == 1.0);
}

TEST_CASE("the distance to an ellipsoid is a lower bound with the right sign") {
  const Vec3 radii{1, 0.25, 0.5};
  const auto bound = [&](const Vec3& p) { return distance_own_frame(primitive(PrimitiveKind::ellipsoid, radii), p); };
  CHECK(bound({2, 0, 0}) == 0.25);
  CHECK(bound({0, 0.5, 0}) == 0.25);
  CHECK(bound({0, 0, 0}) == -0.25);
  Random random;
  for (int k = 0; k < 1000; ++k) {
    // A point of the surface, and one at a known distance or less from it.
    const Vec3 direction = random.vector(1.0);
    const Vec3 unit = (1.0 / length(direction)) * direction;
    const Vec3 surface{radii.x * unit.x, radii.y * unit.y, radii.z * unit.z};
    const Vec3 offset = random.vector(0.5);
    CHECK(std::abs(bound(surface + offset)) <= length(offset) + 1e-15);
  }
}

TEST_CASE("boxes around primitives hold them and touch them") {
  Random random;
  for (const Primitive& own : one_of_each) {
    if (own.kind == PrimitiveKind::half_space) continue;
    for (int k = 0; k < 50; ++k) {
      Primitive p = own;
      p.pose = random.pose(1.0);
      const Pose outer = random.pose(1.0);
      const Bounds box = around(p, outer);
      CAPTURE(static_cast<int>(p.kind));
      // Along each axis the support of the solid, seen from far away: lines in a plane just inside the box meet it.
      Bounds met;
      for (int n = 0; n < 4000; ++n) {
        const Vec3 from = to_local(
            outer, Vec3{random.between(box.low.x, box.high.x), random.between(box.low.y, box.high.y), box.low.z});
        const Line line{from, rotate(inverse(outer.orientation), {0, 0, 1})};
        const Interval found = inside(p, line);
        if (found.empty()) continue;
        met.include(to_outer(outer, line.origin + found.from * line.direction));
        met.include(to_outer(outer, line.origin + found.to * line.direction));
      }
      CHECK(met.low.z >= box.low.z - 1e-12);
      CHECK(met.high.z <= box.high.z + 1e-12);
      // 4000 lines leave gaps of about 0.03 m; corners of the box and the tip of the cone are the worst.
      CHECK(difference(met.low, box.low) < 0.1);
      CHECK(difference(met.high, box.high) < 0.1);
    }
  }
}

TEST_CASE("the box around a turned box reaches to its corners") {
  const Bounds box = around(primitive(PrimitiveKind::box, {1, 1, 3}),
                            {{10, 0, 0}, from_axis_angle({0, 0, 1}, 0.25 * 3.14159265358979323846)});
  CHECK_THAT(box.high.x, WithinAbs(10 + 2 * half_root, 1e-14));
  CHECK_THAT(box.low.y, WithinAbs(-2 * half_root, 1e-14));
  CHECK(box.high.z == 3.0);
  CHECK(reach(around(primitive(PrimitiveKind::half_space, {0, 0, 1}), {})) == endless);
}
