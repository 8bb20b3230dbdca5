// Sand that swings in a parabolic bowl and is brought to rest by Coulomb friction.
// Derivation: the surface is always a plane, of slope 2 H0 X/a^2, and every grain moves with X'. Then
// X'' = -w^2 X - alpha mu g sgn(X'), w^2 = 2 alpha g H0/a^2: a pendulum with dry friction. Without friction: Thacker
// (1981).
#pragma once

#include <cmath>

namespace sandsim {

/// Bed H0 (x^2/a^2 - 1), depth H0 (1 - ((x - X)/a)^2), released from rest at X = start, hbar = alpha h.
class CoulombBowl {
 public:
  CoulombBowl(double height, double half_width, double start, double effective_gravity, double friction_coefficient)
      : height_(height),
        half_width_(half_width),
        start_(start),
        frequency_(std::sqrt(2.0 * effective_gravity * height) / half_width),
        bound_(0.5 * friction_coefficient * half_width * half_width / height) {}

  /// [m] elevation of the bed.
  double bed(double x) const { return height_ * (x * x / (half_width_ * half_width_) - 1.0); }

  /// [m] depth at x [m] and t [s].
  double depth(double x, double t) const {
    const double xi = (x - displacement(t)) / half_width_;
    return std::abs(xi) < 1.0 ? height_ * (1.0 - xi * xi) : 0.0;
  }

  /// [m/s] velocity at x [m] and t [s]; zero where there is no sand.
  double velocity(double x, double t) const {
    if (std::abs(x - displacement(t)) >= half_width_) return 0.0;
    const Swing swing = swing_at(t);
    return -(swing.start - swing.center) * frequency_ * std::sin(frequency_ * swing.time);
  }

  /// [m] X, the displacement of the sand.
  double displacement(double t) const {
    const Swing swing = swing_at(t);
    return swing.center + (swing.start - swing.center) * std::cos(frequency_ * swing.time);
  }

  /// [m] where it stops: the first turning point with |X| <= mu a^2/(2 H0). Infinitely late without friction.
  double rest_displacement() const { return turning_point(half_swings()); }
  /// [s]
  double stop_time() const { return half_swings() * half_period(); }
  /// [s] half a period, from turning point to turning point, with or without friction.
  double half_period() const { return std::acos(-1.0) / frequency_; }

 private:
  /// One swing between turning points: from `start` about `center`, for the time `time`.
  struct Swing {
    double start, center, time;
  };

  /// Turning point n: |X| loses 2 bound_ in each half swing, and changes sides.
  double turning_point(double n) const {
    const double reach = std::abs(start_) - 2.0 * bound_ * n;
    return std::copysign(1.0, start_) * (std::fmod(n, 2.0) == 0.0 ? reach : -reach);
  }
  /// Half swings until rest: the first n with |turning point| <= bound_.
  double half_swings() const { return std::fmax(0.0, std::ceil((std::abs(start_) / bound_ - 1.0) / 2.0)); }

  Swing swing_at(double t) const {
    const double n = std::floor(std::fmax(t, 0.0) / half_period());
    if (n >= half_swings()) return {rest_displacement(), rest_displacement(), 0.0};
    const double from = turning_point(n);
    return {from, std::copysign(bound_, from), std::fmax(t, 0.0) - n * half_period()};
  }

  double height_;      // [m] H0
  double half_width_;  // [m] a
  double start_;       // [m]
  double frequency_;   // [1/s] w
  double bound_;       // [m] mu a^2/(2 H0): friction holds the sand within it
};

}  // namespace sandsim
