// Cliffs, towers, films and sand poured on rough ground: the places where height-field schemes run wild.
#include <algorithm>
#include <cmath>

#include "tests/support/catch.hpp"
#include "tests/verification/cases.hpp"

using namespace sandsim;
using namespace sandsim::test;

TEST_CASE("sand that runs over a cliff of fifty cells keeps its speed and its time step") {
  struct Result {
    double speed, first_step, smallest_step, fallen;
  };
  const auto fall = [](Method method) {
    // A dam of 0.1 m at 0.2 m before the edge, which is at x = 0.5 m.
    Case test = make_case(120, 12, 0.01, 0.5, method);
    test.initial.bed = at_centers(test.grid(), [](double x, double) { return x < 0.5 ? 0.5 : 0.0; });
    test.initial.depth = at_centers(test.grid(), [](double x, double) { return x < 0.3 ? 0.1 : 0.0; });
    Run run(test);
    run.watch_speed();
    const double first = run.backend().stable_step();
    run.until(4.0);
    const std::vector<double> depth = run.depth();
    double fallen = 0.0;
    for (int i = 50; i < 120; ++i) fallen += depth[test.index(i)];
    CHECK_THAT(sum(depth), WithinRel(sum(test.initial.depth), 1e-13));
    return Result{run.max_speed(), first, run.smallest_step(), fallen};
  };
  const Result order2 = fall(Method::order2), order1 = fall(Method::order1);
  CHECK(order2.speed <= 1.2);
  CHECK(order1.speed <= 1.2);
  CHECK(order2.fallen > 0.0);
  CHECK(order1.fallen > 0.0);
  // The step follows the speed; it never collapses.
  CHECK(order2.smallest_step >= 0.3 * order2.first_step);
  CHECK(order1.smallest_step >= 0.3 * order1.first_step);
}

TEST_CASE("a tower of one cell in a flow does not spray") {
  const auto speed = [](Method method) {
    Case test = make_case(80, 40, 0.02, 0.3, method);
    test.initial.bed.assign(test.grid().cell_count(), 0.0);
    test.initial.bed[test.index(45, 20)] = 1.0;
    test.initial.depth = at_centers(test.grid(), [](double x, double) { return x < 0.6 ? 0.3 : 0.0; });
    Run run(test);
    run.watch_speed();
    run.until(2.0);
    CHECK_THAT(sum(run.depth()), WithinRel(sum(test.initial.depth), 1e-13));
    return run.max_speed();
  };
  // The tip of the frictionless dam break would run at 2 sqrt(g h) = 3.43 m/s.
  CHECK(speed(Method::order2) <= 2.6);
  CHECK(speed(Method::order1) <= 2.2);
}

TEST_CASE("a film of a micrometre slides down a steep slope like a block") {
  // 60 degrees, mu = 0.5: after 0.35 s the block has slid g (tan 60 - 0.5) t^2/2 = 0.7395 m.
  const double fall = std::sqrt(3.0), mu = 0.5, time = 0.35, exact = 0.5 * 9.8 * (fall - mu) * time * time;
  const auto shift = [&](Method method, Precision precision, double thickness) {
    Case test = make_case(300, 1, 0.01, mu, method, precision);
    test.initial.bed = at_centers(test.grid(), [&](double x, double) { return -fall * x; });
    test.initial.depth = at_centers(test.grid(), [&](double x, double) {
      return std::abs(x - 1.0) < 0.5 ? thickness * std::pow(std::cos((x - 1.0) * 3.14159265358979), 2) : 0.0;
    });
    Run run(test);
    run.until(time);
    const std::vector<double> depth = run.depth();
    double moment = 0.0;
    for (int i = 0; i < 300; ++i) moment += depth[test.index(i)] * test.grid().x(i);
    return moment / sum(depth) - 1.0;
  };
  CHECK_THAT(shift(Method::order2, Precision::float64, 1e-6), WithinRel(exact, 2e-3));
  CHECK_THAT(shift(Method::order1, Precision::float64, 1e-6), WithinRel(exact, 1.2e-2));
  // Single precision holds a bed of metres to 2e-7 m: ridges of a quarter of that film, but nothing beside 0.1 mm.
  CHECK_THAT(shift(Method::order2, Precision::float32, 1e-4), WithinRel(exact, 2e-3));
  CHECK_THAT(shift(Method::order2, Precision::float32, 1e-6), WithinRel(exact, 2.5e-2));
}

TEST_CASE("sand poured on rough terrain keeps to speeds below those of its fall") {
  const auto pour = [](Method method, Precision precision) {
    Random random(5);
    Case test = make_case(64, 64, 0.02, 0.6, method, precision);
    // A hill of 0.7 m with steps of up to four spacings from cell to cell.
    test.initial.bed = at_centers(
        test.grid(), [&](double x, double y) { return 0.7 * std::exp(-4.0 * (x * x + y * y)) + random(0.0, 0.08); });
    test.initial.depth =
        at_centers(test.grid(), [](double x, double y) { return std::hypot(x - 0.15, y - 0.2) < 0.2 ? 0.15 : 0.0; });
    Run run(test);
    run.watch_speed();
    run.until(3.0);
    // Rounding of four thousand depths over a thousand steps.
    CHECK_THAT(sum(run.depth()), WithinRel(sum(test.initial.depth), precision == Precision::float64 ? 1e-13 : 2e-6));
    return run.max_speed();
  };
  CHECK(pour(Method::order2, Precision::float64) <= 3.0);
  CHECK(pour(Method::order1, Precision::float64) <= 3.0);
  CHECK(pour(Method::order2, Precision::float32) <= 3.0);
}

TEST_CASE("a block on a slope above and below the friction angle moves as the balance of forces says") {
  // Uniform sand round a periodic slope cannot be built (the bed would jump), so the middle of a long slope is watched.
  const double mu = 0.5, time = 0.2, start = 0.3;
  for (const Method method : {Method::order2, Method::order1}) {
    for (const double part : {0.98, 1.02}) {
      Case test = make_case(200, 1, 0.01, mu, method);
      test.initial.bed = at_centers(test.grid(), [&](double x, double) { return -part * mu * x; });
      test.initial.depth.assign(test.grid().cell_count(), 0.05);
      const auto speed_after = [&](double speed) {
        test.momentum_x.assign(test.grid().cell_count(), 0.05 * speed);
        Run run(test);
        run.until(time);
        return run.momentum_x()[100] / run.depth()[100];
      };
      const double gain = 9.8 * mu * (part - 1.0) * time;
      // The bed is a plane, up to the rounding of its elevations.
      CHECK_THAT(speed_after(start), WithinAbs(start + gain, 1e-9));
      CHECK_THAT(speed_after(0.0), WithinAbs(std::max(0.0, gain), 1e-9));
    }
  }
}
