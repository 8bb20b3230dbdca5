// What stands stays: states that friction can hold do not change by a single bit.
#include <cmath>

#include "tests/support/catch.hpp"
#include "tests/verification/statics.hpp"

using namespace sandsim;
using namespace sandsim::test;

namespace {

constexpr Precision precisions[] = {Precision::float32, Precision::float64};
constexpr Method balanced[] = {Method::order2, Method::order1};

/// The state after `steps` stable steps, and one much shorter and one three times too long, has the same bits.
bool stays(const Case& test, int steps) {
  Run run(test);
  const StateArrays before = run.backend().state();
  const double dt = run.backend().stable_step();
  run.step(0.01 * dt);
  run.step(3.0 * dt);
  for (int n = 0; n < steps; ++n) run.step();
  return same_bits(before, run.backend().state());
}

/// A box of sand that collapses onto a flat bed, run until it rests.
Run collapsed_box(Method method, Precision precision, int rows) {
  Case test = make_case(24, rows, 0.02, std::tan(0.5236), method, precision);
  test.initial.depth =
      at_centers(test.grid(), [&](double x, double y) { return x < 0.16 && (rows == 1 || y < 0.2) ? 0.12 : 0.0; });
  Run run(test);
  REQUIRE(run.until_rest(20.0));
  return run;
}

}  // namespace

TEST_CASE("forty rough piles just below the friction angle keep every bit") {
  for (const Precision precision : precisions) {
    for (const Method method : balanced) {
      int kept = 0;
      for (std::uint64_t seed = 0; seed < 40; ++seed) {
        const Case test = rough_pile(seed, method, precision);
        // The set-up is as steep as it says: the test would be empty otherwise.
        REQUIRE(steepness(test) <= 0.999);
        REQUIRE(steepness(test) > 0.98);
        kept += stays(test, 20);
      }
      CHECK(kept == 40);
    }
  }
}

TEST_CASE("forty lakes with islands keep every bit without friction") {
  for (const Precision precision : precisions) {
    for (const Method method : balanced) {
      int kept = 0;
      for (std::uint64_t seed = 0; seed < 40; ++seed) kept += stays(lake(seed, method, precision), 20);
      CHECK(kept == 40);
    }
  }
}

TEST_CASE("cones just below their friction angle keep every bit") {
  for (const Precision precision : precisions) {
    for (const Method method : balanced) {
      for (const double angle : {15.0, 30.0, 45.0, 60.0}) {
        CAPTURE(angle, name(method));
        CHECK(stays(cone(angle, 0.999, method, precision), 200));
      }
    }
  }
}

TEST_CASE("a cone above its friction angle does not stay") {
  // The opposite of the tests above: without it they could pass on a scheme that never moves.
  for (const Method method : balanced) CHECK_FALSE(stays(cone(30.0, 1.02, method, Precision::float64), 5));
}

TEST_CASE("a collapsed box rests exactly and keeps every bit over a hundred thousand steps") {
  for (const Precision precision : precisions) {
    for (const Method method : balanced) {
      for (const int rows : {1, 20}) {
        CAPTURE(name(method), rows);
        Run run = collapsed_box(method, precision, rows);
        const GridStatistics statistics = run.backend().statistics();
        CHECK(statistics.moving_cells == 0);
        CHECK(statistics.max_speed == 0.0);
        // No face steeper than mu by more than 1e-5: rounding of depths of 0.1 m over a spacing of 0.02 m in float32.
        CHECK(run.backend().slope_violation() <= 1e-5);
        const StateArrays before = run.backend().state();
        for (int n = 0; n < 100000; ++n) run.step();
        CHECK(same_bits(before, run.backend().state()));
      }
    }
  }
}

TEST_CASE("the repaired paper scheme keeps a flat layer and a heap below its angle") {
  // Its rest gate needs exact zeros of velocity, which friction provides where the slope is below mu. Those zeros may
  // be negative ones: depths are compared bit by bit, momenta as numbers.
  Case layer = make_case(24, 20, 0.02, 0.5, Method::repaired);
  layer.initial.depth.assign(layer.grid().cell_count(), 0.1);
  for (const Case& test : {layer, cone(30.0, 0.9, Method::repaired, Precision::float64)}) {
    Run run(test);
    for (int n = 0; n < 100; ++n) run.step();
    CHECK(run.depth() == test.initial.depth);
    CHECK(run.backend().statistics().moving_cells == 0);
  }
}

TEST_CASE("an empty grid and a single cell stay as they are") {
  for (const Method method : balanced) {
    Case empty = make_case(8, 8, 0.1, 0.5, method);
    Run nothing(empty);
    CHECK(std::isinf(nothing.backend().stable_step()));
    nothing.step(0.01);
    CHECK(sum(nothing.depth()) == 0.0);
    Case single = make_case(1, 1, 0.1, 0.5, method);
    single.initial.depth = {0.3};
    CHECK(stays(single, 10));
  }
}
