// Flows with known solutions and moving shores in two dimensions, and smooth flows without any.
// Bounds are the measured errors rounded up by about 5 %: the runs are deterministic.
#include <cmath>

#include "solver/reference/coulomb_bowl.hpp"
#include "solver/reference/parabolic_cap.hpp"
#include "solver/reference/thacker.hpp"
#include "tests/support/catch.hpp"
#include "tests/verification/cases.hpp"

using namespace sandsim;
using namespace sandsim::test;

namespace {

constexpr double pi = 3.14159265358979323846;

// ---- the bowl with friction ----
// Swings from 0.5 m to -0.3 and 0.1, which is just what friction holds.
const CoulombBowl bowl(0.1, 1.0, 0.5, 9.8, 0.02);

struct BowlResult {
  double fast;  // relative error of the depth where the sand first moves fastest, half-way through the first swing
  double late;  // the same in the second swing: the turn between them is one step long, more or less
  double rest;  // [m] centre of mass at rest
};
BowlResult swing(int n, Method method) {
  Case test = make_case(n, 1, 4.0 / n, 0.02, method);
  test.config.grid.origin = {-2.0, 0.0};
  test.initial.bed = at_centers(test.grid(), [](double x, double) { return bowl.bed(x); });
  test.initial.depth = cell_means(test.grid(), [](double x, double) { return bowl.depth(x, 0.0); });
  Run run(test);
  const auto error = [&](double time) {
    run.until(time);
    return relative_l1(run.depth(), cell_means(test.grid(), [&](double x, double) { return bowl.depth(x, time); }));
  };
  const double fast = error(0.5 * bowl.half_period()), late = error(1.5 * bowl.half_period());
  run.until_rest(4.0 * bowl.stop_time());
  const std::vector<double> depth = run.depth();
  double moment = 0.0;
  for (int i = 0; i < n; ++i) moment += depth[test.index(i)] * test.grid().x(i);
  return {fast, late, moment / sum(depth)};
}

// ---- a smooth flow in a periodic square of 1 m ----
/// Everything moves everywhere, so that friction is smooth too.
Case smooth_flow(int n, Method method, double friction) {
  Case test = make_case(n, n, 1.0 / n, friction, method);
  constexpr BoundaryKind around = BoundaryKind::periodic;
  test.config.boundaries = {around, around, around, around};
  const auto wave = [](double x, double y, double phase) {
    return std::sin(2.0 * pi * x + phase) * std::cos(2.0 * pi * y - phase);
  };
  const auto depth = [=](double x, double y) { return 1.0 + 0.1 * wave(x, y, 0.3); };
  test.initial.bed = cell_means(test.grid(), [=](double x, double y) { return 0.1 * wave(x, y, 1.7); });
  test.initial.depth = cell_means(test.grid(), depth);
  test.momentum_x =
      cell_means(test.grid(), [=](double x, double y) { return depth(x, y) * (1.0 + 0.3 * wave(y, x, 0.9)); });
  test.momentum_y =
      cell_means(test.grid(), [=](double x, double y) { return depth(x, y) * (0.7 + 0.3 * wave(x, y, 2.1)); });
  return test;
}

struct Fields {
  std::vector<double> depth, x, y;
};
Fields smooth_result(int n, Method method, double friction) {
  Run run(smooth_flow(n, method, friction));
  run.until(0.08);
  return {run.depth(), run.momentum_x(), run.momentum_y()};
}

/// Order from the differences of three grids: cell averages are compared with those of the next finer grid.
Fields orders(Method method, double friction, int n) {
  const Fields coarse = smooth_result(n, method, friction), middle = smooth_result(2 * n, method, friction),
               fine = smooth_result(4 * n, method, friction);
  const auto order = [&](const auto& field) {
    Grid two, four;
    two.cells = {2 * n, 2 * n};
    four.cells = {4 * n, 4 * n};
    return std::log2(relative_l1(field(coarse), coarsen(two, field(middle), 2)) /
                     relative_l1(field(middle), coarsen(four, field(fine), 2)));
  };
  return {{order([](const Fields& f) { return f.depth; })},
          {order([](const Fields& f) { return f.x; })},
          {order([](const Fields& f) { return f.y; })}};
}

}  // namespace

TEST_CASE("sand in a bowl swings and stops as the exact solution does") {
  const BowlResult coarse = swing(200, Method::order2), fine = swing(400, Method::order2);
  CHECK(fine.fast <= 3.7e-4);
  CHECK(std::log2(coarse.fast / fine.fast) >= 1.6);
  CHECK(fine.late <= 1.02e-3);
  CHECK_THAT(fine.rest, WithinAbs(bowl.rest_displacement(), 1.3e-3));
  const BowlResult coarse1 = swing(200, Method::order1), fine1 = swing(400, Method::order1);
  CHECK(fine1.fast <= 4.7e-3);
  CHECK(std::log2(coarse1.fast / fine1.fast) >= 0.85);
  CHECK_THAT(fine1.rest, WithinAbs(bowl.rest_displacement(), 7e-3));
}

TEST_CASE("the repaired paper scheme converges in the bowl") {
  const BowlResult coarse = swing(200, Method::repaired), fine = swing(400, Method::repaired);
  CHECK(fine.fast <= 3.3e-3);
  CHECK(std::log2(coarse.fast / fine.fast) >= 0.85);
}

TEST_CASE("a smooth flow without friction converges in second order in all three fields") {
  const Fields order = orders(Method::order2, 0.0, 64);
  CHECK(order.depth[0] >= 1.9);
  CHECK(order.x[0] >= 1.9);
  CHECK(order.y[0] >= 1.9);
}

TEST_CASE("a smooth flow with friction converges in second order in all three fields") {
  // With friction along the velocity at the end of the step, instead of the step's mean direction, these are 1.5
  // to 1.9.
  const Fields order = orders(Method::order2, 0.3, 64);
  CHECK(order.depth[0] >= 1.9);
  CHECK(order.x[0] >= 1.9);
  CHECK(order.y[0] >= 1.9);
}

TEST_CASE("a smooth flow converges in first order with order 1 and the paper's repaired scheme") {
  for (const Method method : {Method::order1, Method::repaired}) {
    CAPTURE(name(method));
    const Fields order = orders(method, 0.0, 32);
    CHECK(order.depth[0] >= 0.85);
    CHECK(order.x[0] >= 0.85);
    CHECK(order.y[0] >= 0.85);
  }
}

TEST_CASE("the breathing paraboloid of Thacker returns after a period") {
  const RadialThacker exact(0.1, 1.0, 0.9, 9.8);
  const auto error = [&](int n, Method method) {
    Case test = make_case(n, n, 3.0 / n, 0.0, method);
    test.config.grid.origin = {-1.5, -1.5};
    test.initial.bed = at_centers(test.grid(), [&](double x, double y) { return exact.bed(std::hypot(x, y)); });
    const auto depth = [&](double x, double y) { return exact.depth(std::hypot(x, y), 0.0); };
    test.initial.depth = cell_means(test.grid(), depth);
    Run run(test);
    run.until(exact.period());
    return relative_l1(run.depth(), cell_means(test.grid(), depth));
  };
  const double coarse = error(80, Method::order2), fine = error(160, Method::order2);
  CHECK(fine <= 5.6e-3);
  CHECK(std::log2(coarse / fine) >= 1.2);
  CHECK(error(160, Method::order1) <= 2.8e-2);
}

TEST_CASE("the circling plane of Thacker returns after a period") {
  const PlanarThacker exact(0.1, 1.0, 0.5, 9.8);
  const auto error = [&](int n, Method method) {
    Case test = make_case(n, n, 3.2 / n, 0.0, method);
    test.config.grid.origin = {-1.6, -1.6};
    test.initial.bed = at_centers(test.grid(), [&](double x, double y) { return exact.bed(x, y); });
    const auto depth = [&](double x, double y) { return exact.depth(x, y, 0.0); };
    test.initial.depth = cell_means(test.grid(), depth);
    test.momentum_y = test.initial.depth;
    for (double& q : test.momentum_y) q *= exact.velocity_y(0.0);
    Run run(test);
    run.until(exact.period());
    return relative_l1(run.depth(), cell_means(test.grid(), depth));
  };
  const double coarse = error(64, Method::order2), fine = error(128, Method::order2);
  CHECK(fine <= 7.4e-3);
  CHECK(std::log2(coarse / fine) >= 1.2);
  CHECK(error(128, Method::order1) <= 7.1e-2);
}

TEST_CASE("a parabolic cap slides down a slope and spreads as Savage and Hutter say") {
  const double fall = 0.8, mu = 0.3, height = 0.1, half_length = 1.0;
  const ParabolicCap exact(1.5, height, half_length, 9.8, 9.8 * (fall - mu));
  REQUIRE(exact.all_downhill());
  const auto error = [&](int n, Method method) {
    Case test = make_case(n, 1, 8.0 / n, mu, method);
    test.initial.bed = at_centers(test.grid(), [&](double x, double) { return -fall * x; });
    test.initial.depth = cell_means(test.grid(), [&](double x, double) { return exact.depth(x, 0.0); });
    Run run(test);
    run.until(1.0);
    return relative_l1(run.depth(), cell_means(test.grid(), [&](double x, double) { return exact.depth(x, 1.0); }));
  };
  const double coarse = error(200, Method::order2), fine = error(400, Method::order2);
  CHECK(fine <= 1.7e-3);
  CHECK(std::log2(coarse / fine) >= 1.35);
  CHECK(error(400, Method::order1) <= 1.71e-2);
}

TEST_CASE("a radial cap spreads as its exact solution") {
  const RadialCap exact(0.2, 0.4, 9.8);
  const auto error = [&](int n, Method method) {
    Case test = make_case(n, n, 2.0 / n, 0.0, method);
    test.config.grid.origin = {-1.0, -1.0};
    const auto depth = [&](double t) {
      return cell_means(test.grid(), [&, t](double x, double y) { return exact.depth(std::hypot(x, y), t); });
    };
    test.initial.depth = depth(0.0);
    Run run(test);
    run.until(0.25);
    return relative_l1(run.depth(), depth(0.25));
  };
  const double coarse = error(64, Method::order2), fine = error(128, Method::order2);
  CHECK(fine <= 3.2e-3);
  CHECK(std::log2(coarse / fine) >= 1.4);
  CHECK(error(128, Method::order1) <= 2.5e-2);
}
