// The exact dam breaks satisfy the equations that they claim to solve.
#include <cmath>

#include "solver/reference/dam_break.hpp"
#include "solver/reference/stoker.hpp"
#include "solver/reference/travelling_shock.hpp"
#include "solver/reference/two_layer_dam_break.hpp"
#include "tests/support/catch.hpp"
#include "tests/verification/substitution.hpp"

using namespace sandsim;
using namespace sandsim::test;

namespace {
// The finite differences are good to 1e-9 (substitution.hpp); fans of order one in h and ten in u stay below this.
constexpr double substituted = 1e-7;
}  // namespace

TEST_CASE("the dam break on a slope satisfies the equations inside its fan") {
  const double gravity = 7.0, drive = 1.3;
  const DamBreak exact(0.5, 1.2, gravity, drive);
  const auto h = [&](double x, double t) { return exact.depth(x, t); };
  const auto u = [&](double x, double t) { return exact.velocity(x, t); };
  const auto force = [&](double, double, double h_x) { return -gravity * h_x + drive; };
  for (const double part : {0.05, 0.3, 0.6, 0.95}) {
    const double t = 0.7, x = exact.back(t) + part * (exact.tip(t) - exact.back(t));
    const Residual residual = substitute(h, u, force, x, t);
    CHECK_THAT(residual.mass, WithinAbs(0.0, substituted));
    CHECK_THAT(residual.momentum, WithinAbs(0.0, substituted));
  }
  // Behind the fan the sand slides as a block.
  CHECK(exact.depth(exact.back(0.7) - 0.1, 0.7) == 1.2);
  CHECK_THAT(exact.velocity(exact.back(0.7) - 0.1, 0.7), WithinRel(drive * 0.7, 1e-15));
}

TEST_CASE("the dam break is continuous and conserves volume") {
  const DamBreak exact(0.0, 1.0, 9.8, 0.0);
  CHECK_THAT(exact.depth(exact.back(0.4) + 1e-9, 0.4), WithinAbs(1.0, 1e-8));
  CHECK_THAT(exact.depth(exact.tip(0.4) - 1e-9, 0.4), WithinAbs(0.0, 1e-15));
  // Hand-checkable: at the dam h = 4/9 h0 at all times.
  CHECK_THAT(exact.depth(0.0, 0.3), WithinRel(4.0 / 9.0, 1e-14));
  // The midpoint rule is exact to (width/n)^2 times the kink at the fan's end.
  CHECK_THAT(volume([&](double x) { return exact.depth(x, 0.4); }, -3.0, 3.0), WithinRel(3.0, 1e-7));
}

TEST_CASE("a dam break against friction stops where a free body would") {
  // mu = 0.5, alpha = 0.8: the tip flies 2 h0/mu and that does not depend on alpha.
  const DamBreak full(0.4, 0.2, 9.8, -9.8 * 0.5), scaled(0.4, 0.2, 0.8 * 9.8, -0.8 * 9.8 * 0.5);
  CHECK_FALSE(full.has_profile());
  CHECK_THAT(full.tip(full.stop_time()), WithinRel(0.4 + 2.0 * 0.2 / 0.5, 1e-14));
  CHECK_THAT(scaled.tip(100.0), WithinRel(1.2, 1e-14));
  CHECK_THAT(scaled.stop_time() / full.stop_time(), WithinRel(1.0 / std::sqrt(0.8), 1e-14));
  CHECK(full.tip(full.stop_time() + 1.0) == full.tip(full.stop_time()));
}

TEST_CASE("the signal of the wall travels through the fan as a characteristic") {
  for (const double drive : {0.0, 2.0}) {
    const DamBreak exact(1.0, 0.5, 9.8, drive);
    const double t = 1.5, e = 1e-5, x = exact.wall_influence(0.0, t);
    REQUIRE(x > exact.back(t));
    const double speed = (exact.wall_influence(0.0, t + e) - exact.wall_influence(0.0, t - e)) / (2.0 * e);
    // Finite difference in time: error 1e-10 times the third derivative.
    CHECK_THAT(speed, WithinRel(exact.velocity(x, t) + std::sqrt(9.8 * exact.depth(x, t)), 1e-8));
  }
}

TEST_CASE("Stoker's solution satisfies the equations and the jump conditions") {
  const double gravity = 9.8, h0 = 1.0, hr = 0.1, t = 0.5;
  const StokerDamBreak exact(0.0, h0, hr, gravity);
  const auto h = [&](double x, double s) { return exact.depth(x, s); };
  const auto u = [&](double x, double s) { return exact.velocity(x, s); };
  const auto force = [&](double, double, double h_x) { return -gravity * h_x; };
  const Residual fan = substitute(h, u, force, -0.5 * t, t);
  CHECK_THAT(fan.mass, WithinAbs(0.0, substituted));
  CHECK_THAT(fan.momentum, WithinAbs(0.0, substituted));
  // Rankine-Hugoniot for the momentum, which the construction did not use in this form.
  const double hm = exact.plateau_depth(), um = exact.plateau_velocity(), s = exact.shock_speed();
  CHECK_THAT(hm * um * um + 0.5 * gravity * (hm * hm - hr * hr), WithinRel(s * hm * um, 1e-12));
  // Stoker's polynomial for c_m, as the literature has it, scaled by its largest term.
  const double c = std::sqrt(gravity * hm), c2 = gravity * hr, c0 = std::sqrt(gravity * h0);
  const double left = 8.0 * c2 * c * c * (c0 - c) * (c0 - c), right = std::pow(c * c - c2, 2) * (c * c + c2);
  CHECK_THAT(left, WithinRel(right, 1e-12));
  CHECK_THAT(exact.depth(t * (2.0 * c0 - 3.0 * c) - 1e-9, t), WithinRel(hm, 1e-7));
  // Volume: the midpoint rule errs by at most one cell of 5e-4 times the jump at the shock.
  CHECK_THAT(volume([&](double x) { return exact.depth(x, t); }, -5.0, 5.0), WithinAbs(5.5, 2e-4));
}

TEST_CASE("the two-layer dam break satisfies the equations in both of its parts") {
  const double g = 9.8, alpha = 0.8, cap = 0.05, t = 0.35;
  const TwoLayerDamBreak exact(0.0, 0.4, alpha, cap, g, 0.0);
  const auto h = [&](double x, double s) { return exact.depth(x, s); };
  const auto u = [&](double x, double s) { return exact.velocity(x, s); };
  const auto force = [&](double x, double s, double h_x) {
    const double depth = exact.depth(x, s);
    return -g * std::min(alpha * depth, cap) / depth * h_x;
  };
  for (const double x : {-0.2, 0.0, 0.15, 0.4, 0.7, 0.9}) {
    const Residual residual = substitute(h, u, force, x, t);
    CHECK_THAT(residual.mass, WithinAbs(0.0, substituted));
    CHECK_THAT(residual.momentum, WithinAbs(0.0, substituted));
  }
  const double c = std::sqrt(g * cap), junction = c * (std::log(0.4 / 0.0625) - 1.0) * t;
  CHECK_THAT(exact.depth(junction, t), WithinRel(0.0625, 1e-12));
  CHECK_THAT(volume([&](double x) { return exact.depth(x, t); }, -1.0, 1.0), WithinRel(0.4, 1e-7));
  // 0.4 x 0.2 m at 30.9 degrees: the tip of the flume stops at 0.922 m (rounded to a millimetre).
  const double mu = std::tan(30.9 / 180.0 * std::acos(-1.0));
  CHECK_THAT(TwoLayerDamBreak(0.4, 0.2, 0.8, 0.05, 9.8, -mu).tip(9.0), WithinAbs(0.922, 5e-4));
}

TEST_CASE("a cap that never acts leaves the one-layer dam break") {
  const TwoLayerDamBreak two(0.0, 0.4, 0.8, 0.5, 9.8, 0.0);
  const DamBreak one(0.0, 0.4, 0.8 * 9.8, 0.0);
  for (const double x : {-0.5, -0.2, 0.0, 0.3, 0.8, 2.0}) {
    // Two roundings of the same expression.
    CHECK_THAT(two.depth(x, 0.3), WithinAbs(one.depth(x, 0.3), 1e-14));
    CHECK_THAT(two.velocity(x, 0.3), WithinAbs(one.velocity(x, 0.3), 1e-13));
  }
  CHECK_THAT(two.tip(0.3), WithinRel(one.tip(0.3), 1e-14));
}

TEST_CASE("the shock of a stream against a wall conserves mass and momentum") {
  for (const double cap : {1e30, 0.03}) {
    const double h1 = 0.1, u1 = 1.5, alpha = 0.9, g = 9.8;
    const TravellingShock exact(h1, u1, alpha, cap, g);
    const double h2 = exact.piled_depth(), s = exact.shock_speed();
    CHECK_THAT(h1 * (u1 + s), WithinRel(h2 * s, 1e-12));
    const double flux = cap > 1.0 ? 0.5 * alpha * g * (h2 * h2 - h1 * h1) : g * cap * (h2 - h1);
    CHECK_THAT(h1 * u1 * (u1 + s), WithinRel(flux, 1e-12));
  }
}
