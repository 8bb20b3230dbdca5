// Mirrored, transposed and rotated scenes give the mirrored, transposed and rotated result, and neither threads nor
// tiles can be seen in a result: bit for bit.
#include <cmath>

#include "tests/support/catch.hpp"
#include "tests/verification/cases.hpp"

using namespace sandsim;
using namespace sandsim::test;

namespace {

/// First swap the axes, then mirror: all eight symmetries of the square.
struct Symmetry {
  bool swap, mirror_x, mirror_y;
};
constexpr Symmetry symmetries[] = {{false, true, false}, {false, false, true}, {false, true, true},
                                   {true, false, false}, {true, true, false},  {true, false, true},
                                   {true, true, true}};

/// The transformed array of a scalar on a grid of nx * ny.
std::vector<double> transform(const std::vector<double>& values, int nx, int ny, const Symmetry& by) {
  if (values.size() <= 1) return values;
  const int columns = by.swap ? ny : nx, rows = by.swap ? nx : ny;
  std::vector<double> out(values.size());
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const int a = by.mirror_x ? columns - 1 - i : i, b = by.mirror_y ? rows - 1 - j : j;
      const int from_i = by.swap ? b : a, from_j = by.swap ? a : b;
      out[static_cast<std::size_t>(j * columns + i)] = values[static_cast<std::size_t>(from_j * nx + from_i)];
    }
  }
  return out;
}

std::vector<double> negated(std::vector<double> values, bool negate) {
  if (negate) {
    for (double& v : values) v = -v;
  }
  return values;
}

/// The momentum of a transformed case.
struct Momentum {
  std::vector<double> x, y;
};
Momentum transform(const std::vector<double>& x, const std::vector<double>& y, int nx, int ny, const Symmetry& by) {
  Momentum out{transform(by.swap ? y : x, nx, ny, by), transform(by.swap ? x : y, nx, ny, by)};
  out.x = negated(out.x, by.mirror_x);
  out.y = negated(out.y, by.mirror_y);
  return out;
}

Boundaries transform(Boundaries sides, const Symmetry& by) {
  if (by.swap) sides = {sides.y_min, sides.y_max, sides.x_min, sides.x_max};
  if (by.mirror_x) std::swap(sides.x_min, sides.x_max);
  if (by.mirror_y) std::swap(sides.y_min, sides.y_max);
  return sides;
}

Case transform(const Case& test, const Symmetry& by) {
  Case out = test;
  const int nx = test.grid().cells[0], ny = test.grid().cells[1];
  if (by.swap) out.config.grid.cells = {ny, nx};
  out.config.boundaries = transform(test.config.boundaries, by);
  const auto field = [&](const std::vector<double>& values) { return transform(values, nx, ny, by); };
  out.initial = {field(test.initial.bed), field(test.initial.depth), field(test.initial.friction_coefficient),
                 field(test.initial.hbar_scale), field(test.initial.hbar_cap)};
  const Momentum momentum = transform(test.momentum_x, test.momentum_y, nx, ny, by);
  out.momentum_x = momentum.x;
  out.momentum_y = momentum.y;
  return out;
}

/// Sand in motion on rough ground, partly dry; maps of the material for every other seed.
Case wild(std::uint64_t seed, Method method, Precision precision) {
  Random random(seed + 77);
  Case test = make_case(37, 22, 0.03, 0.4, method, precision);
  const auto anything = [&](double low, double high) {
    return at_centers(test.grid(), [&](double, double) { return random(low, high); });
  };
  test.initial.bed = anything(0.0, 0.08);
  test.initial.depth = anything(-0.1, 0.2);
  for (double& h : test.initial.depth) h = std::max(0.0, h);
  if (seed % 2 == 1) {
    test.initial.friction_coefficient = anything(0.1, 0.9);
    test.initial.hbar_scale = anything(0.4, 1.0);
    test.initial.hbar_cap = anything(0.02, 0.1);
  }
  test.momentum_x = anything(-0.1, 0.1);
  test.momentum_y = anything(-0.1, 0.1);
  for (std::size_t k = 0; k < test.initial.depth.size(); ++k) {
    if (test.initial.depth[k] == 0.0 || random() < 0.3) test.momentum_x[k] = test.momentum_y[k] = 0.0;
  }
  return test;
}

/// Steps together and compares as numbers: the mirror image of a zero may be a negative zero.
bool commutes(const Case& test, const Symmetry& by, int steps) {
  const int nx = test.grid().cells[0], ny = test.grid().cells[1];
  Run plain(test), image(transform(test, by));
  for (int n = 0; n < steps; ++n) {
    if (plain.backend().stable_step() != image.backend().stable_step()) return false;
    plain.step();
    image.step();
  }
  const Momentum momentum = transform(plain.momentum_x(), plain.momentum_y(), nx, ny, by);
  return transform(plain.depth(), nx, ny, by) == image.depth() && momentum.x == image.momentum_x() &&
         momentum.y == image.momentum_y();
}

void check_all(Method method, Precision precision, const Boundaries& sides) {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    Case test = wild(seed, method, precision);
    test.config.boundaries = sides;
    for (const Symmetry& by : symmetries) {
      CAPTURE(name(method), seed, by.swap, by.mirror_x, by.mirror_y);
      CHECK(commutes(test, by, 40));
    }
  }
}

constexpr Boundaries walls{};
constexpr Boundaries mixed{BoundaryKind::open, BoundaryKind::wall, BoundaryKind::periodic, BoundaryKind::periodic};

}  // namespace

TEST_CASE("the balanced scheme commutes with mirrors and rotations in both orders and precisions") {
  for (const Method method : {Method::order2, Method::order1}) {
    for (const Precision precision : {Precision::float32, Precision::float64}) {
      check_all(method, precision, walls);
      check_all(method, precision, mixed);
    }
  }
}

TEST_CASE("the paper's scheme commutes with mirrors and rotations") {
  for (const Method method : {Method::repaired, Method::printed}) {
    for (const Precision precision : {Precision::float32, Precision::float64}) check_all(method, precision, walls);
  }
}

TEST_CASE("one row gives what a plane of equal rows gives along each of them") {
  // A row bounds its step without the second axis, so that the steps are imposed.
  for (const Method method : {Method::order2, Method::order1, Method::repaired}) {
    Case row = make_case(60, 1, 0.02, 0.4, method), plane = make_case(60, 5, 0.02, 0.4, method);
    const auto bed = [](double x, double) { return 0.03 * std::sin(9.0 * x); };
    const auto sand = [](double x, double) { return x < 0.5 ? 0.2 : 0.0; };
    row.initial.bed = at_centers(row.grid(), bed);
    plane.initial.bed = at_centers(plane.grid(), bed);
    row.initial.depth = at_centers(row.grid(), sand);
    plane.initial.depth = at_centers(plane.grid(), sand);
    Run one(row), many(plane);
    for (int n = 0; n < 100; ++n) {
      one.step(1e-3);
      many.step(1e-3);
    }
    const std::vector<double> all = many.depth(), line = one.depth();
    for (int j = 0; j < 5; ++j) {
      CHECK(std::equal(line.begin(), line.end(), all.begin() + static_cast<std::ptrdiff_t>(plane.index(0, j))));
    }
  }
}

TEST_CASE("threads and tiles leave no trace in the result") {
  for (const Method method : {Method::order2, Method::order1, Method::repaired}) {
    for (const Precision precision : {Precision::float32, Precision::float64}) {
      Case test = wild(1, method, precision);
      Run plain(test);
      for (int n = 0; n < 20; ++n) plain.step();
      for (const int threads : {1, 2, 3}) {
        for (const int columns : {0, 8, 16}) {
          for (const int rows : {0, 1, 5}) {
            CAPTURE(name(method), threads, columns, rows);
            test.config.threads = threads;
            test.config.tile_columns = columns;
            test.config.block_rows = rows;
            Run other(test);
            for (int n = 0; n < 20; ++n) other.step();
            CHECK(same_bits(plain.backend().state(), other.backend().state()));
            CHECK(plain.time() == other.time());
          }
        }
      }
    }
  }
}
