// A parabolic cap of sand that spreads and slides.
// Source: Savage & Hutter (1989) in one dimension; the radial form by substitution of the same ansatz.
#pragma once

#include <cmath>

#include "solver/reference/numeric.hpp"

namespace sandsim {

/// 1-D cap h = (H0/lambda)(1 - xi^2), xi = (x - center(t))/(L0 lambda), released at t = 0 on a slope, hbar = alpha h.
/// effective_gravity G = alpha g, net_acceleration m0 = alpha g (tan(slope) - mu) [m/s^2].
class ParabolicCap {
 public:
  ParabolicCap(double center, double height, double half_length, double effective_gravity, double net_acceleration)
      : center_(center),
        height_(height),
        half_length_(half_length),
        acceleration_(net_acceleration),
        rate_(2.0 * std::sqrt(effective_gravity * height) / half_length) {}

  /// True if no grain ever moves against the slope, so that friction never changes sign. The tail's velocity is
  /// m0 t - L0 lambda', and lambda'/t falls with t from its start 2 G H0/L0^2. Without friction it always holds.
  bool all_downhill() const { return acceleration_ >= 0.5 * half_length_ * rate_ * rate_; }

  /// [m] depth at x [m] and t [s].
  double depth(double x, double t) const {
    const double stretch = lambda(t), xi = (x - position(t)) / (half_length_ * stretch);
    return std::abs(xi) < 1.0 ? height_ / stretch * (1.0 - xi * xi) : 0.0;
  }

  /// [m/s] velocity at x [m] and t [s]; zero where there is no sand.
  double velocity(double x, double t) const {
    const double stretch = lambda(t), offset = x - position(t);
    if (std::abs(offset) >= half_length_ * stretch) return 0.0;
    return acceleration_ * t + offset / stretch * rate_ * std::sqrt(1.0 - 1.0 / stretch);
  }

  /// [m] centre of the cap.
  double position(double t) const { return center_ + 0.5 * acceleration_ * t * t; }
  /// [m] its leading edge.
  double tip(double t) const { return position(t) + half_length_ * lambda(t); }

  /// [-] length over initial length. lambda' = rate sqrt(1 - 1/lambda) integrates to
  /// rate t = sqrt(lambda (lambda - 1)) + ln(sqrt(lambda) + sqrt(lambda - 1)), which grows with lambda.
  double lambda(double t) const {
    if (t <= 0.0) return 1.0;
    // With lambda = 1 + z^2 the left-hand side is smooth at the start, and 1 + rate t bounds lambda.
    const auto excess = [&](double z) { return z * std::sqrt(1.0 + z * z) + std::asinh(z) - rate_ * t; };
    const double z = bisect(excess, 0.0, std::sqrt(1.0 + rate_ * t));
    return 1.0 + z * z;
  }

 private:
  double center_;        // [m]
  double height_;        // [m] H0
  double half_length_;   // [m] L0
  double acceleration_;  // [m/s^2] m0
  double rate_;          // [1/s] 2 sqrt(G H0)/L0
};

/// Axisymmetric cap on a flat bed without friction, released at t = 0:
/// h = (H0/lambda^2)(1 - (r/(R0 lambda))^2), lambda^2 = 1 + 2 G H0 t^2/R0^2.
class RadialCap {
 public:
  RadialCap(double height, double radius, double effective_gravity)
      : height_(height), radius_(radius), rate2_(2.0 * effective_gravity * height / (radius * radius)) {}

  /// [m] depth at the distance r [m] from the axis.
  double depth(double r, double t) const {
    const double stretch2 = 1.0 + rate2_ * t * t, xi2 = r * r / (radius_ * radius_ * stretch2);
    return xi2 < 1.0 ? height_ / stretch2 * (1.0 - xi2) : 0.0;
  }

  /// [m/s] outward velocity at the distance r [m]; zero where there is no sand.
  double velocity(double r, double t) const { return r < tip(t) ? r * rate2_ * t / (1.0 + rate2_ * t * t) : 0.0; }

  /// [m] radius of the edge.
  double tip(double t) const { return radius_ * std::sqrt(1.0 + rate2_ * t * t); }

 private:
  double height_;  // [m] H0
  double radius_;  // [m] R0
  double rate2_;   // [1/s^2] 2 G H0/R0^2
};

}  // namespace sandsim
