#include "solver/objects/shape.hpp"

#include <stdexcept>

#include "tests/objects/support.hpp"

using namespace sandsim::objects;
using namespace sandsim::test;

namespace {

constexpr Interval everywhere{-endless, endless};

Primitive box(const Vec3& half, const Vec3& center = {}) {
  return {PrimitiveKind::box, half, {center, {}}};
}
Primitive sphere(double radius, const Vec3& center = {}) {
  return {PrimitiveKind::sphere, {radius, 0, 0}, {center, {}}};
}

Shape joined(const Primitive& a, const Primitive& b, Instruction operation) {
  return {{a, b}, {Instruction::primitive, Instruction::primitive, operation}};
}

Intervals vertical(const Shape& shape, double x, double y, const Interval& range = everywhere, double spacing = 1) {
  return inside(shape.view(), {{x, y, 0}, {0, 0, 1}}, range, spacing);
}

/// Exact distances to a sphere at the points of a grid around it.
Shape sampled_sphere(double radius, int points) {
  auto grid = std::make_shared<DistanceGrid>();
  grid->points = {points, points, points};
  grid->spacing = 3.0 * radius / (points - 1);
  grid->origin = {-1.5 * radius, -1.5 * radius, -1.5 * radius};
  for (int k = 0; k < points; ++k) {
    for (int j = 0; j < points; ++j) {
      for (int i = 0; i < points; ++i) {
        const Vec3 p = grid->origin + grid->spacing * Vec3{1.0 * i, 1.0 * j, 1.0 * k};
        grid->values.push_back(static_cast<float>(length(p) - radius));
      }
    }
  }
  return Shape(std::move(grid));
}

}  // namespace

TEST_CASE("a union of boxes is inside where one of them is") {
  const Shape shape = joined(box({1, 1, 1}), box({1, 1, 1}, {0, 0, 4}), Instruction::unite);
  const Intervals found = vertical(shape, 0, 0);
  REQUIRE(found.count == 2);
  CHECK(found.items[0].from == -1.0);
  CHECK(found.items[0].to == 1.0);
  CHECK(found.items[1].from == 3.0);
  CHECK(found.items[1].to == 5.0);
  CHECK(distance(shape.view(), {0, 0, 2}) == 1.0);
}

TEST_CASE("parts that touch give one interval") {
  const Intervals found = vertical(joined(box({1, 1, 1}), box({1, 1, 1}, {0, 0, 2}), Instruction::unite), 0, 0);
  REQUIRE(found.count == 1);
  CHECK(found.items[0].from == -1.0);
  CHECK(found.items[0].to == 3.0);
}

TEST_CASE("a difference has a hole and an intersection is what both share") {
  const Intervals hollow = vertical(joined(box({2, 2, 2}), sphere(1), Instruction::subtract), 0, 0);
  REQUIRE(hollow.count == 2);
  CHECK(hollow.items[0].to == -1.0);
  CHECK(hollow.items[1].from == 1.0);
  const Intervals shared = vertical(joined(box({2, 2, 2}), sphere(1), Instruction::intersect), 0, 0);
  REQUIRE(shared.count == 1);
  CHECK(shared.items[0].from == -1.0);
  CHECK(vertical(joined(box({1, 1, 1}), sphere(1, {0, 0, 5}), Instruction::intersect), 0, 0).count == 0);
}

TEST_CASE("intervals are cut to the range that is asked for") {
  const Shape shape(sphere(1));
  CHECK(vertical(shape, 0, 0, {0.25, 0.5}).items[0].from == 0.25);
  CHECK(vertical(shape, 0, 0, {0.25, 0.5}).items[0].to == 0.5);
  CHECK(vertical(shape, 0, 0, {1, 2}).count == 0);
  CHECK(vertical(shape, 0, 0, {0.5, 0.5}).count == 0);
  const Shape floor({PrimitiveKind::half_space, {0, 0, 1}, {}});
  CHECK(vertical(floor, 3, 4, {-2, 5}).items[0].to == 0.0);
}

TEST_CASE("random set operations agree with the sign of the distance") {
  Random random;
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<Primitive> primitives;
    std::vector<Instruction> instructions;
    for (int k = 0; k < 8; ++k) {
      const auto kind = static_cast<PrimitiveKind>(static_cast<int>(random.between(0, 7)));
      primitives.push_back(
          {kind, {random.between(0.2, 1), random.between(0.2, 1), random.between(0.2, 1)}, random.pose(1.0)});
      if (kind == PrimitiveKind::half_space) {
        primitives.back().size = (1 / length(primitives.back().size)) * primitives.back().size;
      }
      instructions.push_back(Instruction::primitive);
      if (k > 0) instructions.push_back(static_cast<Instruction>(static_cast<int>(random.between(1, 4))));
    }
    const Shape shape(primitives, instructions);
    const Line line{random.vector(1.0), random.vector(1.0)};
    const Intervals found = inside(shape.view(), line, {-3, 3}, 1);
    int next = 0;
    for (double t = -2.995; t < 3; t += 0.01) {
      while (next < found.count && found.items[next].to < t) ++next;
      const bool is_inside = next < found.count && found.items[next].from < t;
      const double d = distance(shape.view(), line.origin + t * line.direction);
      CAPTURE(trial, t, d);
      // On a surface rounding decides.
      if (std::abs(d) > 1e-12) CHECK(is_inside == (d < 0));
    }
  }
}

TEST_CASE("a sampled sphere has the intervals of the sphere to the grid's second order") {
  double before = 1.0;
  for (const int points : {17, 33, 65}) {
    const Shape shape = sampled_sphere(1.0, points);
    double largest = 0.0;
    for (const double x : {0.0, 0.3, 0.6, 0.8}) {
      const Intervals found = vertical(shape, x, 0.1, everywhere, 0.05);
      REQUIRE(found.count == 1);
      const double exact = std::sqrt(1 - x * x - 0.01);
      largest = std::fmax(largest, std::abs(found.items[0].to - exact));
    }
    // Trilinear interpolation errs by spacing^2/8 of the curvature: a quarter for half the spacing, 0.4 with some room
    // for where the lines happen to lie in the cells.
    CHECK(largest < 0.4 * before);
    before = largest;
  }
  CHECK(before < 1e-3);
}

TEST_CASE("a sampled shape is followed when its grid is turned, and ends with its range") {
  const Shape upright = sampled_sphere(1.0, 33);
  const Intervals found = inside(upright.view(), {{-5, 0, 0}, {1, 0, 0}}, {0, 5}, 0.02);
  REQUIRE(found.count == 1);
  // The spacing of the grid is 0.09: curvature 1 gives 1e-3.
  CHECK_THAT(found.items[0].from, WithinAbs(4, 1e-3));
  CHECK(found.items[0].to == 5.0);
  CHECK(inside(upright.view(), {{-5, 4, 0}, {1, 0, 0}}, {0, 5}, 0.02).count == 0);
}

TEST_CASE("the box around a sampled shape holds its inside and little more") {
  const Bounds box = sampled_sphere(1.0, 33).bounds({{10, 0, 0}, {}});
  CHECK(box.low.x <= 9.0);
  CHECK(box.low.x > 9.0 - 2 * 3.0 / 32);
  CHECK(box.high.z >= 1.0);
}

TEST_CASE("the distance beyond a grid goes on growing") {
  const Shape shape = sampled_sphere(1.0, 33);
  CHECK_THAT(distance(shape.view(), {3, 0, 0}), WithinAbs(2.0, 1e-6));  // values are float32
  CHECK(distance(shape.view(), {3, 3, 3}) > 2.0);
}

TEST_CASE("boxes around set operations follow them") {
  const Primitive floor{PrimitiveKind::half_space, {0, 0, 1}, {}};
  CHECK(joined(sphere(1), floor, Instruction::unite).bounds({}).high.x == endless);
  CHECK(joined(sphere(1), floor, Instruction::intersect).bounds({}).high.x == 1.0);
  CHECK(joined(sphere(1), floor, Instruction::subtract).bounds({}).high.z == 1.0);
  CHECK(joined(sphere(1), sphere(1, {3, 0, 0}), Instruction::intersect).bounds({}).empty());
}

TEST_CASE("shapes that make no sense cannot be made") {
  const Primitive p = sphere(1);
  CHECK_THROWS_AS(Shape({p}, {}), std::invalid_argument);
  CHECK_THROWS_AS(Shape({p, p}, {Instruction::primitive, Instruction::primitive}), std::invalid_argument);
  CHECK_THROWS_AS(Shape({p}, {Instruction::primitive, Instruction::unite}), std::invalid_argument);
  CHECK_THROWS_AS(Shape({p, p}, {Instruction::primitive}), std::invalid_argument);
  CHECK_THROWS_AS(Shape(std::make_shared<DistanceGrid>()), std::invalid_argument);
}
