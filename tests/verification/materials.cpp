// Jumps of the material between neighbours: the layer that flows, and friction.
#include <algorithm>
#include <cmath>

#include "tests/support/catch.hpp"
#include "tests/verification/cases.hpp"

using namespace sandsim;
using namespace sandsim::test;

TEST_CASE("sand between dilute layers of unlike depth keeps to speeds that its energy explains") {
  // 100 m of sand in cells of 5 m whose layers are 1e-6 m and all of the depth, in turn and at the dam. A cell that
  // took the force of its neighbour's layer alone got to 1e5 m/s.
  for (const Method method : {Method::order2, Method::order1}) {
    for (const Precision precision : {Precision::float32, Precision::float64}) {
      for (const bool stripes : {true, false}) {
        CAPTURE(name(method), stripes);
        Case test = make_case(64, 1, 5.0, 0.577, method, precision);
        test.initial.hbar_scale = {1.0};
        test.initial.hbar_cap.assign(64, 100.0);
        for (std::size_t i = 0; i < 64; ++i) {
          if (stripes ? i % 2 == 0 : i < 20) test.initial.hbar_cap[i] = 1e-6;
        }
        test.initial.depth = at_centers(test.grid(), [](double x, double) { return x < 100.0 ? 100.0 : 0.0; });
        Run run(test);
        run.watch_speed();
        run.until(20.0);
        CHECK(run.max_speed() <= 2.5 * std::sqrt(9.8 * 100.0));
        // Rounding of 64 depths over some hundred steps.
        CHECK_THAT(sum(run.depth()), WithinRel(2000.0, precision == Precision::float64 ? 1e-13 : 2e-6));
      }
    }
  }
}

TEST_CASE("a heap on friction that changes from cell to cell comes to exact rest") {
  for (const Method method : {Method::order2, Method::order1}) {
    for (const Precision precision : {Precision::float32, Precision::float64}) {
      CAPTURE(name(method));
      Random random(12);
      Case test = make_case(40, 40, 0.01, 0.5, method, precision);
      test.initial.friction_coefficient.resize(1600);
      std::generate(test.initial.friction_coefficient.begin(), test.initial.friction_coefficient.end(),
                    [&] { return std::tan(random(0.17, 1.05)); });
      test.initial.depth =
          at_centers(test.grid(), [](double x, double y) { return std::hypot(x - 0.2, y - 0.2) < 0.06 ? 0.12 : 0.0; });
      Run run(test);
      CHECK(run.until_rest(60.0));
      // Of the smaller of the two coefficients at a face.
      CHECK(run.backend().slope_violation() <= 0.01);
    }
  }
}
