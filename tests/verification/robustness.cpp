// Anything may come: no negative depth, no NaN, no lost volume, no speed that energy cannot explain.
#include <algorithm>
#include <cmath>

#include "tests/support/catch.hpp"
#include "tests/verification/cases.hpp"

using namespace sandsim;
using namespace sandsim::test;

namespace {

struct RandomCase {
  Case test;
  double start_speed = 0.0;  // [m/s]
  double relief = 0.0;       // [m] range of the bed
  double deepest = 0.0;      // [m]
};

/// Ground, sand, friction, hbar and momentum over several orders of magnitude; dry, shallow and deep cells mixed.
RandomCase random_case(std::uint64_t seed, Method method, Precision precision) {
  Random random(seed + 4242);
  const int nx = static_cast<int>(random(2.0, 30.0)), ny = seed % 5 == 0 ? 1 : static_cast<int>(random(2.0, 30.0));
  const double spacing = std::pow(10.0, random(-3.0, 1.0)), depth = spacing * std::pow(10.0, random(-2.0, 1.5));
  RandomCase made{make_case(nx, ny, spacing, 0.0, method, precision)};
  Case& test = made.test;
  const std::size_t cells = test.grid().cell_count();
  const bool maps = seed % 3 == 1, rough = seed % 4 != 3, capped = seed % 2 == 1, frictionless = seed % 7 == 0;
  made.relief = rough ? depth * random(0.0, 3.0) : 0.0;
  const std::size_t materials = maps ? cells : 1;
  test.initial.friction_coefficient.assign(materials, 0.0);
  test.initial.hbar_scale.assign(materials, 1.0);
  test.initial.hbar_cap.assign(materials, 1e30);
  for (std::size_t k = 0; k < materials; ++k) {
    if (!frictionless) test.initial.friction_coefficient[k] = random(0.05, 2.0);
    if (capped) test.initial.hbar_cap[k] = depth * random(0.02, 1.0);
    if (seed % 6 < 2) test.initial.hbar_scale[k] = random(0.2, 1.0);
  }
  made.start_speed = std::sqrt(9.8 * depth) * random(0.0, 3.0);
  if (rough) test.initial.bed.assign(cells, 0.0);
  test.momentum_x.assign(cells, 0.0);
  test.momentum_y.assign(cells, 0.0);
  for (std::size_t k = 0; k < cells; ++k) {
    if (rough) test.initial.bed[k] = made.relief * random();
    const double kind = random(), h = kind < 0.3 ? 0.0 : (kind < 0.4 ? 1e-6 : 1.0) * depth * random();
    test.initial.depth[k] = h;
    made.deepest = std::max(made.deepest, h);
    if (random() < 0.4) continue;
    const double direction = random(0.0, 6.283185307179586), q = h * made.start_speed * random();
    test.momentum_x[k] = q * std::cos(direction);
    if (ny > 1) test.momentum_y[k] = q * std::sin(direction);
  }
  return made;
}

/// Sum without rounding worth mentioning.
double exact_sum(const std::vector<double>& values) {
  long double total = 0.0L;
  for (const double v : values) total += v;
  return static_cast<double>(total);
}

struct Worst {
  double mass = 0.0;   // relative error of the volume
  double speed = 0.0;  // largest speed over u0 + sqrt(g (h + relief))
  double body = 0.0;   // the same, in cells of more than 1 % of the deepest
  double depth = 0.0;  // smallest depth over the deepest
};

void watch_speed(const Run& run, const RandomCase& made, double scale, Worst& worst) {
  const std::vector<double> depth = run.depth(), x = run.momentum_x(), y = run.momentum_y();
  for (std::size_t k = 0; k < depth.size(); ++k) {
    if (depth[k] <= 1e-8 * made.test.grid().spacing) continue;
    const double speed = std::hypot(x[k], y[k]) / depth[k] / scale;
    worst.speed = std::max(worst.speed, speed);
    if (depth[k] > 0.01 * made.deepest) worst.body = std::max(worst.body, speed);
  }
}

Worst run_cases(std::uint64_t count, Method method, Precision precision, double courant_factor) {
  Worst worst;
  for (std::uint64_t seed = 0; seed < count; ++seed) {
    CAPTURE(seed);
    RandomCase made = random_case(seed, method, precision);
    Run run(made.test);
    const double scale = made.start_speed + std::sqrt(9.8 * (made.deepest + made.relief));
    const double before = exact_sum(run.depth());
    for (int n = 0; n < 60; ++n) {
      const double dt = run.backend().stable_step();
      if (std::isinf(dt)) break;
      run.step(courant_factor * dt);  // throws if a value is not finite or a depth is negative
      watch_speed(run, made, scale, worst);
    }
    const std::vector<double> depth = run.depth();
    worst.depth = std::min(worst.depth, *std::min_element(depth.begin(), depth.end()) / made.deepest);
    worst.mass = std::max(worst.mass, std::abs(exact_sum(depth) / before - 1.0));
  }
  return worst;
}

}  // namespace

TEST_CASE("random cases stay positive finite and conservative at three times the largest stable step") {
  for (const Method method : {Method::order2, Method::order1}) {
    CAPTURE(name(method));
    // The stable step holds Courant numbers of 0.6 and 0.9; three times the bound of 1 is 5 and 3.4 times as much.
    const double factor = method == Method::order2 ? 5.0 : 10.0 / 3.0;
    const Worst wide = run_cases(200, method, Precision::float64, factor);
    CHECK(wide.depth >= 0.0);
    CHECK(wide.mass <= 1e-14);
    const Worst narrow = run_cases(200, method, Precision::float32, factor);
    CHECK(narrow.depth >= 0.0);
    CHECK(narrow.mass <= 2e-6);
  }
}

TEST_CASE("random cases keep to speeds that their energy explains") {
  for (const Method method : {Method::order2, Method::order1}) {
    for (const Precision precision : {Precision::float32, Precision::float64}) {
      CAPTURE(name(method));
      const Worst worst = run_cases(200, method, precision, 1.0);
      CHECK(worst.body <= 1.7);
      // One case in fifty leaves films below 1e-4 of the deepest sand at dx/dt, where the scheme cuts speeds off: up to
      // 4.5 times the scale here, though 2.5 is what one would like. They carry no momentum to speak of.
      CHECK(worst.speed <= 4.8);
      CHECK(worst.mass <= (precision == Precision::float64 ? 1e-14 : 2e-6));
    }
  }
}
