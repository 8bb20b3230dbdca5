// Dam break onto a layer of sand, without net friction: a fan, a plateau and a shock.
// Source: Stoker (1957), Water Waves, section 10.8.
#pragma once

#include <cmath>

#include "solver/reference/numeric.hpp"

namespace sandsim {

/// Depth `depth` at x < dam and `downstream_depth` at x > dam, both at rest, hbar = alpha h, G = alpha g [m/s^2],
/// and tan(slope) = mu (both zero on the flat). Needs 0 < downstream_depth < depth.
class StokerDamBreak {
 public:
  StokerDamBreak(double dam, double depth, double downstream_depth, double effective_gravity)
      : dam_(dam),
        depth_(depth),
        downstream_depth_(downstream_depth),
        gravity_(effective_gravity),
        celerity_(std::sqrt(effective_gravity * depth)),
        plateau_celerity_(solve_plateau()) {}

  /// [m] depth at x [m] and t [s].
  double depth(double x, double t) const {
    const double speed = t > 0.0 ? (x - dam_) / t : at_start(x);
    if (speed <= -celerity_) return depth_;
    if (speed <= fan_end_speed()) return (2.0 * celerity_ - speed) * (2.0 * celerity_ - speed) / (9.0 * gravity_);
    return speed < shock_speed() ? plateau_depth() : downstream_depth_;
  }

  /// [m/s] velocity at x [m] and t [s].
  double velocity(double x, double t) const {
    const double speed = t > 0.0 ? (x - dam_) / t : at_start(x);
    if (speed <= -celerity_ || speed >= shock_speed()) return 0.0;
    return speed <= fan_end_speed() ? 2.0 / 3.0 * (celerity_ + speed) : plateau_velocity();
  }

  /// [m] position of the shock.
  double shock(double t) const { return dam_ + shock_speed() * t; }
  /// [m/s] speed of the shock, from the conservation of mass across it.
  double shock_speed() const { return plateau_depth() * plateau_velocity() / (plateau_depth() - downstream_depth_); }
  double plateau_depth() const { return plateau_celerity_ * plateau_celerity_ / gravity_; }  // [m]
  double plateau_velocity() const { return 2.0 * (celerity_ - plateau_celerity_); }          // [m/s]
  /// [s] moment at which the fan reaches a wall at `wall` < dam.
  double wall_time(double wall) const { return (dam_ - wall) / celerity_; }

 private:
  double at_start(double x) const { return x < dam_ ? -2.0 * celerity_ : 2.0 * shock_speed(); }
  double fan_end_speed() const { return 2.0 * celerity_ - 3.0 * plateau_celerity_; }

  /// The plateau's sqrt(G h): its velocity behind the fan, 2 (c0 - c), equals that behind the shock,
  /// (h - hr) sqrt(G (h + hr)/(2 h hr)). The difference falls with c, so that bisection cannot fail.
  double solve_plateau() const {
    const double downstream = std::sqrt(gravity_ * downstream_depth_);
    const auto excess = [&](double c) {
      const double h = c * c, hr = downstream * downstream;
      return (h - hr) * std::sqrt((h + hr) / (2.0 * h * hr)) - 2.0 * (celerity_ - c);
    };
    return bisect(excess, downstream, celerity_);
  }

  double dam_;               // [m]
  double depth_;             // [m]
  double downstream_depth_;  // [m]
  double gravity_;           // [m/s^2]
  double celerity_;          // [m/s] sqrt(G depth)
  double plateau_celerity_;  // [m/s] sqrt(G plateau depth)
};

}  // namespace sandsim
