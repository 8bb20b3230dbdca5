// Dam break of the two-layer model, hbar = min(alpha h, cap).
// Derivation: characteristics move with u -+ c, c = sqrt(g hbar), and u + integral of c/h dh is constant along C+.
// Above the depth cap/alpha c is constant, which gives an exponential profile; below it is Ritter's fan.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace sandsim {

/// Sand of depth `depth` at x < dam, released at t = 0; scale = alpha [-], cap [m], gravity g [m/s^2],
/// net_slope = tan(slope) - mu [-]. The profile is known for net_slope = 0 only; the tip always.
/// A cap above scale * depth never acts, and the solution is DamBreak's.
class TwoLayerDamBreak {
 public:
  TwoLayerDamBreak(double dam, double depth, double scale, double cap, double gravity, double net_slope)
      : dam_(dam),
        depth_(depth),
        gravity_(scale * gravity),
        acceleration_(scale * gravity * net_slope),
        upper_(std::min(depth, cap / scale)),
        celerity_(std::sqrt(scale * gravity * upper_)),
        stretch_(std::log(depth / upper_)) {}

  /// True if depth() and velocity() hold; else only tip() and stop_time() do.
  bool has_profile() const { return acceleration_ == 0.0; }

  /// [m] depth at x [m] and t [s].
  double depth(double x, double t) const {
    if (t <= 0.0) return x < dam_ ? depth_ : 0.0;
    const double speed = (x - dam_) / t;
    if (speed <= -celerity_) return depth_;
    if (speed >= tip_speed()) return 0.0;
    if (speed <= celerity_ * (stretch_ - 1.0)) return depth_ * std::exp(-(1.0 + speed / celerity_));
    return (tip_speed() - speed) * (tip_speed() - speed) / (9.0 * gravity_);
  }

  /// [m/s] velocity at x [m] and t [s]; zero where there is no sand.
  double velocity(double x, double t) const {
    if (t <= 0.0) return 0.0;
    const double speed = (x - dam_) / t;
    if (speed <= -celerity_ || speed >= tip_speed()) return 0.0;
    if (speed <= celerity_ * (stretch_ - 1.0)) return celerity_ + speed;
    return (tip_speed() + 2.0 * speed) / 3.0;
  }

  /// [m] position of the tip: a free body with the initial speed S = c (2 + ln(depth alpha/cap)).
  double tip(double t) const {
    const double moving = std::min(t, stop_time());
    return dam_ + tip_speed() * moving + 0.5 * acceleration_ * moving * moving;
  }

  /// [s] moment at which the tip stops; infinite if it never does.
  double stop_time() const {
    return acceleration_ < 0.0 ? -tip_speed() / acceleration_ : std::numeric_limits<double>::infinity();
  }

  /// [s] moment at which the fan reaches a wall at `wall` < dam.
  double wall_time(double wall) const { return (dam_ - wall) / celerity_; }

 private:
  double tip_speed() const { return celerity_ * (2.0 + stretch_); }

  double dam_;           // [m]
  double depth_;         // [m]
  double gravity_;       // [m/s^2] alpha g
  double acceleration_;  // [m/s^2] of the tip: alpha g (tan(slope) - mu)
  double upper_;         // [m] depth above which hbar is the cap, at most the initial depth
  double celerity_;      // [m/s] sqrt(g hbar) in the sand at rest
  double stretch_;       // [-] ln(depth/upper_)
};

}  // namespace sandsim
