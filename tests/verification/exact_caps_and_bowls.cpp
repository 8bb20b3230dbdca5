// The exact caps and bowls satisfy the equations that they claim to solve.
#include <cmath>

#include "solver/reference/coulomb_bowl.hpp"
#include "solver/reference/parabolic_cap.hpp"
#include "solver/reference/thacker.hpp"
#include "tests/support/catch.hpp"
#include "tests/verification/substitution.hpp"

using namespace sandsim;
using namespace sandsim::test;

namespace {
// The finite differences are good to 1e-9 (substitution.hpp); these solutions are of order one.
constexpr double substituted = 1e-7;
}  // namespace

TEST_CASE("the parabolic cap satisfies the equations while it slides and spreads") {
  const double gravity = 5.0, drive = 4.0;
  const ParabolicCap exact(0.3, 0.2, 0.6, gravity, drive);
  REQUIRE(exact.all_downhill());
  const auto h = [&](double x, double t) { return exact.depth(x, t); };
  const auto u = [&](double x, double t) { return exact.velocity(x, t); };
  const auto force = [&](double, double, double h_x) { return -gravity * h_x + drive; };
  for (const double t : {0.01, 0.3, 1.0}) {
    for (const double xi : {-0.9, -0.2, 0.5, 0.95}) {
      const double x = exact.position(t) + xi * (exact.tip(t) - exact.position(t));
      const Residual residual = substitute(h, u, force, x, t);
      CHECK_THAT(residual.mass, WithinAbs(0.0, substituted));
      CHECK_THAT(residual.momentum, WithinAbs(0.0, substituted));
      CHECK(exact.velocity(x, t) > 0.0);
    }
    const auto profile = [&](double x) { return exact.depth(x, t); };
    // 4/3 H0 L0; the midpoint rule errs by (width/n)^2 times the slope at the edges.
    CHECK_THAT(volume(profile, exact.position(t) - 8.0, exact.position(t) + 8.0), WithinRel(4.0 / 3.0 * 0.12, 1e-5));
  }
  CHECK(exact.lambda(0.0) == 1.0);
  CHECK_FALSE(ParabolicCap(0.3, 0.2, 0.6, gravity, 3.0).all_downhill());
}

TEST_CASE("the radial cap satisfies the equations in polar form") {
  const double gravity = 6.0, t = 0.4;
  const RadialCap exact(0.3, 0.7, gravity);
  // (r h)_t + (r h u)_r = 0 takes r h for the depth; the acceleration needs the slope of h itself.
  const auto rh = [&](double r, double s) { return r * exact.depth(r, s); };
  const auto u = [&](double r, double s) { return exact.velocity(r, s); };
  const auto force = [&](double r, double s, double) {
    return -gravity * (exact.depth(r + 1e-5, s) - exact.depth(r - 1e-5, s)) / 2e-5;
  };
  for (const double part : {0.1, 0.5, 0.9}) {
    const Residual residual = substitute(rh, u, force, part * exact.tip(t), t);
    CHECK_THAT(residual.mass, WithinAbs(0.0, substituted));
    CHECK_THAT(residual.momentum, WithinAbs(0.0, substituted));
  }
  const double pi = std::acos(-1.0);
  const auto ring = [&](double r) { return 2.0 * pi * r * exact.depth(r, t); };
  // pi H0 R0^2/2; midpoint rule as above.
  CHECK_THAT(volume(ring, 0.0, 2.0), WithinRel(0.5 * pi * 0.3 * 0.49, 1e-6));
}

TEST_CASE("the sand in the bowl satisfies the equations in every swing") {
  const double gravity = 9.8, mu = 0.02, height = 0.1;
  const CoulombBowl exact(height, 1.0, 0.5, gravity, mu);
  const auto h = [&](double x, double t) { return exact.depth(x, t); };
  const auto u = [&](double x, double t) { return exact.velocity(x, t); };
  for (const double part : {0.3, 0.7, 1.2, 1.9}) {
    const double t = part * exact.half_period(), sign = part < 1.0 ? -1.0 : 1.0;
    const auto force = [&](double x, double, double h_x) { return -gravity * (h_x + 2.0 * height * x + sign * mu); };
    const double x = exact.displacement(t) + 0.4;
    const Residual residual = substitute(h, u, force, x, t);
    CHECK_THAT(residual.mass, WithinAbs(0.0, substituted));
    CHECK_THAT(residual.momentum, WithinAbs(0.0, substituted));
    CHECK(u(x, t) * sign > 0.0);
  }
}

TEST_CASE("the sand in the bowl stops at the first turning point that friction can hold") {
  // mu a^2/(2 H0) = 0.1: from 0.55 by -0.35 to 0.15, which is too far out, to 0.05.
  const CoulombBowl exact(0.1, 1.0, 0.55, 9.8, 0.02);
  CHECK_THAT(exact.displacement(exact.half_period()), WithinAbs(-0.35, 1e-12));
  CHECK_THAT(exact.displacement(2.0 * exact.half_period()), WithinAbs(0.15, 1e-12));
  CHECK_THAT(exact.rest_displacement(), WithinAbs(0.05, 1e-12));
  CHECK_THAT(exact.stop_time(), WithinRel(3.0 * exact.half_period(), 1e-14));
  CHECK(exact.velocity(0.0, exact.stop_time() + 1.0) == 0.0);
  // Released within the bound it never moves; without friction it never stops.
  CHECK(CoulombBowl(0.1, 1.0, 0.09, 9.8, 0.02).stop_time() == 0.0);
  const CoulombBowl free(0.1, 1.0, 0.5, 9.8, 0.0);
  CHECK_THAT(free.displacement(20.0 * free.half_period()), WithinRel(0.5, 1e-12));
}

TEST_CASE("the bowl without friction moves as the planar solution of Thacker seen from the side") {
  const CoulombBowl bowl(0.1, 1.0, 0.3, 9.8, 0.0);
  const PlanarThacker planar(0.1, 1.0, 0.3, 9.8);
  CHECK_THAT(planar.period(), WithinRel(2.0 * bowl.half_period(), 1e-14));
  // At t = 0 and after half a period the disc lies on the x axis, where both have the same depth.
  CHECK_THAT(planar.depth(0.5, 0.0, bowl.half_period()), WithinAbs(bowl.depth(0.5, bowl.half_period()), 1e-15));
}

TEST_CASE("the planar solution of Thacker satisfies the equations") {
  const double gravity = 9.8, t = 0.6, e = 1e-5, x = 0.2, y = -0.3;
  const PlanarThacker exact(0.1, 1.0, 0.3, gravity);
  const auto surface = [&](double at_x, double at_y) { return exact.depth(at_x, at_y, t) + exact.bed(at_x, at_y); };
  const double s_x = (surface(x + e, y) - surface(x - e, y)) / (2.0 * e);
  const double s_y = (surface(x, y + e) - surface(x, y - e)) / (2.0 * e);
  const double u_t = (exact.velocity_x(t + e) - exact.velocity_x(t - e)) / (2.0 * e);
  const double v_t = (exact.velocity_y(t + e) - exact.velocity_y(t - e)) / (2.0 * e);
  CHECK_THAT(u_t + gravity * s_x, WithinAbs(0.0, substituted));
  CHECK_THAT(v_t + gravity * s_y, WithinAbs(0.0, substituted));
  const double h_t = (exact.depth(x, y, t + e) - exact.depth(x, y, t - e)) / (2.0 * e);
  const double h_x = (exact.depth(x + e, y, t) - exact.depth(x - e, y, t)) / (2.0 * e);
  const double h_y = (exact.depth(x, y + e, t) - exact.depth(x, y - e, t)) / (2.0 * e);
  CHECK_THAT(h_t + exact.velocity_x(t) * h_x + exact.velocity_y(t) * h_y, WithinAbs(0.0, substituted));
}

TEST_CASE("the radial solution of Thacker satisfies the equations in polar form") {
  const double gravity = 9.8;
  const RadialThacker exact(0.1, 1.0, 0.8, gravity);
  const auto rh = [&](double r, double t) { return r * exact.depth(r, t); };
  const auto u = [&](double r, double t) { return exact.velocity(r, t); };
  const auto force = [&](double r, double t, double) {
    const auto surface = [&](double at) { return exact.depth(at, t) + exact.bed(at); };
    return -gravity * (surface(r + 1e-5) - surface(r - 1e-5)) / 2e-5;
  };
  for (const double part : {0.1, 0.35, 0.8}) {
    for (const double r : {0.1, 0.4, 0.7}) {
      const Residual residual = substitute(rh, u, force, r, part * exact.period());
      CHECK_THAT(residual.mass, WithinAbs(0.0, substituted));
      CHECK_THAT(residual.momentum, WithinAbs(0.0, substituted));
    }
  }
  // The sand starts with the radius r0, and its volume, pi h0 a^2/2, stays.
  CHECK(exact.depth(0.8 + 1e-9, 0.0) == 0.0);
  CHECK(exact.depth(0.8 - 1e-9, 0.0) > 0.0);
  const double pi = std::acos(-1.0);
  const auto ring = [&](double r) { return 2.0 * pi * r * exact.depth(r, 0.3); };
  CHECK_THAT(volume(ring, 0.0, 2.0), WithinRel(0.05 * pi, 1e-6));
}
