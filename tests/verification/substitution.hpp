// Puts a candidate solution into the shallow sand equations by central differences.
#pragma once

#include <cmath>

namespace sandsim::test {

/// What remains of h_t + (hu)_x = 0 [m/s] and u_t + u u_x = acceleration [m/s^2] at one point.
struct Residual {
  double mass = 0.0;
  double momentum = 0.0;
};

/// `depth` and `velocity` are functions of (x, t); `acceleration` of (x, t, h_x) is the right-hand side of the second
/// equation. Central differences with a step of 1e-5: their error (1e-10 times a third derivative) and their rounding
/// (1e-16/1e-5) both stay below 1e-9 for solutions of order one.
template <class Depth, class Velocity, class Acceleration>
Residual substitute(Depth depth, Velocity velocity, Acceleration acceleration, double x, double t) {
  constexpr double e = 1e-5;
  const auto flux = [&](double at) { return depth(at, t) * velocity(at, t); };
  const auto dx = [&](auto f) { return (f(x + e) - f(x - e)) / (2.0 * e); };
  const double h_t = (depth(x, t + e) - depth(x, t - e)) / (2.0 * e);
  const double u_t = (velocity(x, t + e) - velocity(x, t - e)) / (2.0 * e);
  const double h_x = dx([&](double at) { return depth(at, t); });
  const double u_x = dx([&](double at) { return velocity(at, t); });
  return {h_t + dx(flux), u_t + velocity(x, t) * u_x - acceleration(x, t, h_x)};
}

/// Volume per width of a depth profile over [from, to] by the midpoint rule with n points.
template <class Depth>
double volume(Depth depth, double from, double to, int n = 20000) {
  double sum = 0.0;
  for (int k = 0; k < n; ++k) sum += depth(from + (k + 0.5) / n * (to - from));
  return sum * (to - from) / n;
}

}  // namespace sandsim::test
