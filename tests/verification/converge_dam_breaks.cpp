// Dam breaks on a flat bed converge to their exact solutions.
// Bounds are the measured errors rounded up by about 5 %: the runs are deterministic, and a change of the scheme that
// costs more than that should be looked at. The orders are those that shocks, kinks and dry tips allow.
#include <cmath>

#include "solver/reference/compare.hpp"
#include "solver/reference/dam_break.hpp"
#include "solver/reference/numeric.hpp"
#include "solver/reference/stoker.hpp"
#include "solver/reference/travelling_shock.hpp"
#include "solver/reference/two_layer_dam_break.hpp"
#include "tests/support/catch.hpp"
#include "tests/verification/cases.hpp"

using namespace sandsim;
using namespace sandsim::test;

namespace {

/// A row of n cells of total length `length`, centred on the dam at x = 0.
Case dam_case(int n, double length, double depth, double downstream, Method method) {
  Case test = make_case(n, 1, length / n, 0.0, method);
  test.config.grid.origin = {-0.5 * length, 0.0};
  test.initial.depth = at_centers(test.grid(), [=](double x, double) { return x < 0.0 ? depth : downstream; });
  return test;
}

template <class Exact>
double depth_error(Run& run, const Exact& exact, double time) {
  run.until(time);
  const auto profile = [&](double x, double) { return exact.depth(x, time); };
  return relative_l1(run.depth(), cell_means(run.set_up().grid(), profile));
}

/// The error of the momentum, relative to the exact one.
template <class Exact>
double momentum_error(const Run& run, const Exact& exact, double time) {
  const auto profile = [&](double x, double) { return exact.depth(x, time) * exact.velocity(x, time); };
  return relative_l1(run.momentum_x(), cell_means(run.set_up().grid(), profile));
}

/// Errors at n = 100, 200, 400 and the order between the last two.
struct Convergence {
  double coarse, middle, fine;
  double order() const { return std::log2(middle / fine); }
};
template <class Measure>
Convergence converge(Measure measure) {
  return {measure(100), measure(200), measure(400)};
}

}  // namespace

TEST_CASE("a dam break on a dry bed converges to the fan of Ritter") {
  const DamBreak exact(0.0, 1.0, 9.8, 0.0);
  double momentum = 0.0;
  const auto errors = [&](Method method) {
    return converge([&](int n) {
      Run run(dam_case(n, 10.0, 1.0, 0.0, method));
      const double error = depth_error(run, exact, 0.6);
      momentum = momentum_error(run, exact, 0.6);
      return error;
    });
  };
  const Convergence order2 = errors(Method::order2);
  CHECK(order2.fine <= 1.95e-3);
  CHECK(order2.order() >= 0.95);
  CHECK(momentum <= 9.2e-3);
  const Convergence order1 = errors(Method::order1);
  CHECK(order1.fine <= 8.7e-3);
  CHECK(order1.order() >= 0.62);
}

TEST_CASE("the paper's scheme converges to the fan of Ritter only when repaired") {
  const DamBreak exact(0.0, 1.0, 9.8, 0.0);
  const auto errors = [&](Method method) {
    return converge([&](int n) {
      Run run(dam_case(n, 10.0, 1.0, 0.0, method));
      return depth_error(run, exact, 0.6);
    });
  };
  const Convergence repaired = errors(Method::repaired), printed = errors(Method::printed);
  CHECK(repaired.fine <= 2.2e-2);
  CHECK(repaired.order() >= 0.55);
  // hu^2/2 solves another problem: its error does not fall.
  CHECK(printed.fine >= 0.09);
  CHECK(printed.order() < 0.1);
}

TEST_CASE("the shock of Stoker's dam break runs at its exact speed") {
  const StokerDamBreak exact(0.0, 1.0, 0.1, 9.8);
  const double time = 0.6, half = 0.5 * (exact.plateau_depth() + 0.1);
  struct Result {
    double error, speed;
  };
  const auto measure = [&](int n, Method method) {
    Run run(dam_case(n, 10.0, 1.0, 0.1, method));
    const double error = depth_error(run, exact, time);
    return Result{error, front(run.set_up().grid(), run.depth(), half) / time / exact.shock_speed()};
  };
  const Result fine2 = measure(400, Method::order2), coarse2 = measure(200, Method::order2);
  CHECK(fine2.error <= 1.23e-3);
  CHECK(std::log2(coarse2.error / fine2.error) >= 0.9);
  CHECK_THAT(fine2.speed, WithinAbs(1.0, 2e-3));
  const Result fine1 = measure(400, Method::order1);
  CHECK(fine1.error <= 6.7e-3);
  CHECK_THAT(fine1.speed, WithinAbs(1.0, 6e-3));
}

TEST_CASE("the repaired paper scheme keeps Stoker's shock within one per cent and the printed one does not") {
  const StokerDamBreak exact(0.0, 1.0, 0.1, 9.8);
  const double time = 0.6, half = 0.5 * (exact.plateau_depth() + 0.1);
  const auto speed = [&](Method method) {
    Run run(dam_case(400, 10.0, 1.0, 0.1, method));
    run.until(time);
    return front(run.set_up().grid(), run.depth(), half) / time / exact.shock_speed();
  };
  CHECK_THAT(speed(Method::repaired), WithinAbs(1.0, 1.2e-2));
  CHECK(speed(Method::printed) < 0.9);
}

TEST_CASE("the two-layer dam break converges to its exact profile") {
  const TwoLayerDamBreak exact(0.0, 0.4, 0.8, 0.05, 9.8, 0.0);
  const auto errors = [&](Method method) {
    return converge([&](int n) {
      Case test = dam_case(n, 3.0, 0.4, 0.0, method);
      test.initial.hbar_scale = {0.8};
      test.initial.hbar_cap = {0.05};
      Run run(test);
      return depth_error(run, exact, 0.35);
    });
  };
  const Convergence order2 = errors(Method::order2), order1 = errors(Method::order1);
  CHECK(order2.fine <= 1.7e-3);
  CHECK(order2.order() >= 0.95);
  CHECK(order1.fine <= 8.1e-3);
  CHECK(order1.order() >= 0.6);
}

TEST_CASE("a dam break down a slope with friction converges to the fan that falls with it") {
  const double fall = 0.4, mu = 0.2, g = 9.8;
  const DamBreak exact(0.0, 1.0, g, g * (fall - mu));
  const auto error = [&](int n, Method method) {
    Case test = dam_case(n, 10.0, 1.0, 0.0, method);
    test.initial.bed = at_centers(test.grid(), [=](double x, double) { return -fall * x; });
    test.initial.friction_coefficient = {mu};
    Run run(test);
    run.until(0.6);
    // Compared where the wall at the upper end has not been felt.
    const double from = exact.wall_influence(-5.0, 0.6);
    const auto reference = cell_means(test.grid(), [&](double x, double) { return exact.depth(x, 0.6); });
    const std::vector<double> computed = run.depth();
    double difference = 0.0, size = 0.0;
    for (std::size_t i = 0; i < computed.size(); ++i) {
      if (test.grid().x(static_cast<int>(i)) < from + test.grid().spacing) continue;
      difference += std::abs(computed[i] - reference[i]);
      size += reference[i];
    }
    return difference / size;
  };
  CHECK(error(400, Method::order2) <= 3.5e-3);
  CHECK(std::log2(error(200, Method::order2) / error(400, Method::order2)) >= 0.9);
  CHECK(error(400, Method::order1) <= 1.35e-2);
}

TEST_CASE("friction stops the tip of a dam break before its exact position and a finer grid brings it closer") {
  const double mu = 0.5985;
  const DamBreak exact(0.4, 0.2, 9.8, -9.8 * mu);
  const auto tip = [&](int n) {
    Case test = make_case(n, 1, 1.2 / n, mu);
    test.initial.depth = at_centers(test.grid(), [](double x, double) { return x < 0.4 ? 0.2 : 0.0; });
    Run run(test);
    REQUIRE(run.until_rest(10.0));
    return front(test.grid(), run.depth(), 0.0);
  };
  const double end = exact.tip(10.0), coarse = tip(60), fine = tip(480);
  CHECK(coarse < end);
  CHECK(fine < end);
  CHECK(fine > coarse);
}

TEST_CASE("a stream that meets a wall piles up to the exact depth and sends the exact shock back") {
  const double h1 = 0.1, u1 = 1.5, mu = 0.4, g = 9.8, length = 4.0;
  const int n = 800;
  struct Result {
    double piled, shock;  // over their exact values
  };
  const auto measure = [&](Method method, double cap, double time) {
    const TravellingShock exact(h1, u1, 1.0, cap, g);
    Case test = make_case(n, 1, length / n, mu, method);
    test.initial.hbar_cap = {cap};
    test.initial.bed = at_centers(test.grid(), [=](double x, double) { return -mu * x; });
    test.initial.depth.assign(test.grid().cell_count(), h1);
    test.momentum_x.assign(test.grid().cell_count(), h1 * u1);
    Run run(test);
    run.until(time);
    // The wall at x = 0 sends a rarefaction, which is still far from the shock.
    const std::vector<double> depth = run.depth();
    const double shock = exact.shock_speed() * time, half = 0.5 * (h1 + exact.piled_depth());
    std::size_t first = 0;
    while (depth[first] < half) ++first;
    const double x = test.grid().x(static_cast<int>(first)) -
                     test.grid().spacing * (depth[first] - half) / (depth[first] - depth[first - 1]);
    double piled = 0.0;
    int cells = 0;
    for (int i = 0; i < n; ++i) {
      if (std::abs(length - test.grid().x(i) - 0.5 * shock) > 0.25 * shock) continue;
      piled += depth[test.index(i)];
      ++cells;
    }
    return Result{piled / cells / exact.piled_depth(), (length - x) / shock};
  };
  for (const double cap : {1e30, 0.05}) {
    const double time = cap > 1.0 ? 0.6 : 1.2;
    const Result order1 = measure(Method::order1, cap, time), order2 = measure(Method::order2, cap, time);
    CHECK_THAT(order1.piled, WithinAbs(1.0, 5e-3));
    CHECK_THAT(order1.shock, WithinAbs(1.0, 8e-3));
    // Order 2 overshoots in the shock, and sand that has stopped keeps what it has: 2 % too deep, on any grid. A known
    // weakness, which this bound keeps from growing.
    CHECK_THAT(order2.piled, WithinAbs(1.0, 2e-2));
    CHECK_THAT(order2.shock, WithinAbs(1.0, 2e-2));
  }
}
