// A stream of sand that piles up against a wall.
// Derivation: mass and momentum across the shock, behind which the sand is at rest. On a slope of tan = mu the stream
// keeps its speed.
#pragma once

#include <cmath>

#include "solver/reference/numeric.hpp"

namespace sandsim {

/// Stream (depth h1, speed u1) against a wall, hbar = min(alpha h, cap), gravity g. The momentum flux is
/// h u^2 + g Phi(h), Phi' = hbar.
class TravellingShock {
 public:
  TravellingShock(double depth, double speed, double scale, double cap, double gravity)
      : depth_(depth), speed_(speed), scale_(scale), cap_(cap), gravity_(gravity), piled_(solve_depth()) {}

  /// [m] depth h2 behind the shock.
  double piled_depth() const { return piled_; }
  /// [m/s] speed of the shock, away from the wall.
  double shock_speed() const { return depth_ * speed_ / (piled_ - depth_); }

 private:
  double phi(double h) const {
    const double upper = cap_ / scale_;
    return h <= upper ? 0.5 * scale_ * h * h : 0.5 * scale_ * upper * upper + cap_ * (h - upper);
  }
  /// g (Phi(h2) - Phi(h1)) (h2 - h1) = h1 h2 u1^2; divided by h2 the left-hand side grows with h2.
  double solve_depth() const {
    const auto excess = [&](double h) {
      return gravity_ * (phi(h) - phi(depth_)) * (h - depth_) / h - depth_ * speed_ * speed_;
    };
    double high = 2.0 * depth_;
    while (excess(high) < 0.0) high *= 2.0;
    return bisect(excess, depth_, high);
  }

  double depth_;    // [m] h1
  double speed_;    // [m/s] u1
  double scale_;    // [-] alpha
  double cap_;      // [m]
  double gravity_;  // [m/s^2]
  double piled_;    // [m] h2
};

}  // namespace sandsim
