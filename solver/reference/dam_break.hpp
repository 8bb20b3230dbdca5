// Dam break on a uniform slope with Coulomb friction, hbar = alpha h.
// Source: Ritter (1892) without driving force; Mangeney, Heinrich & Roche (2000) on a slope; Kerswell (2005) for the
// arresting tip on the flat.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace sandsim {

/// Sand of depth `depth` at x < dam, released at t = 0. Two numbers hold the physics:
///   effective_gravity G = alpha g [m/s^2] and net_acceleration m0 = alpha g (tan(slope) - mu) [m/s^2].
/// With m0 >= 0 the whole mass moves and the fan is known; with m0 < 0 only the tip is: the sand behind the fan stays
/// at rest, and no closed form is known for the profile between.
class DamBreak {
 public:
  DamBreak(double dam, double depth, double effective_gravity, double net_acceleration)
      : dam_(dam),
        depth_(depth),
        gravity_(effective_gravity),
        acceleration_(net_acceleration),
        celerity_(std::sqrt(effective_gravity * depth)) {}

  /// True if depth() and velocity() hold; else only tip() and stop_time() do.
  bool has_profile() const { return acceleration_ >= 0.0; }

  /// [m] depth at x [m] and t [s].
  double depth(double x, double t) const {
    if (t <= 0.0) return x < dam_ ? depth_ : 0.0;
    if (x <= back(t)) return depth_;
    if (x >= tip(t)) return 0.0;
    const double root = 2.0 * celerity_ - (x - dam_) / t + 0.5 * acceleration_ * t;
    return root * root / (9.0 * gravity_);
  }

  /// [m/s] velocity at x [m] and t [s]; zero where there is no sand.
  double velocity(double x, double t) const {
    if (t <= 0.0 || x >= tip(t)) return 0.0;
    if (x <= back(t)) return acceleration_ * t;
    return 2.0 / 3.0 * (celerity_ + (x - dam_) / t + acceleration_ * t);
  }

  /// [m] position of the tip, where the depth vanishes: a free body with the initial speed 2 sqrt(G depth).
  double tip(double t) const {
    const double moving = std::min(t, stop_time());
    return dam_ + 2.0 * celerity_ * moving + 0.5 * acceleration_ * moving * moving;
  }

  /// [s] moment at which the tip stops; infinite if it never does.
  double stop_time() const {
    return acceleration_ < 0.0 ? -2.0 * celerity_ / acceleration_ : std::numeric_limits<double>::infinity();
  }

  /// [m] upper end of the fan: sand at smaller x does not know yet that there was a dam.
  double back(double t) const { return dam_ - celerity_ * t + 0.5 * acceleration_ * t * t; }

  /// [m] the profile of an unbounded reservoir holds at larger x, if the reservoir ends in a wall at `wall` < dam.
  /// Derivation: the wall's first signal is a C+ characteristic. In the frame that falls with m0 it meets the fan's
  /// end after t1 = L/c0 if the sand at the wall was at rest until then (m0 = 0), L/(2 c0) if it left the wall at
  /// t = 0, and inside the fan dx/dt = u + c = 4 c0/3 + x/(3 t) gives x = 2 c0 t - 3 c0 t1^(2/3) t^(1/3).
  double wall_influence(double wall, double t) const {
    const double length = dam_ - wall;
    const bool at_rest = acceleration_ == 0.0;
    const double meeting = length / (at_rest ? celerity_ : 2.0 * celerity_);
    const double fall = 0.5 * acceleration_ * t * t;
    if (t <= meeting) return at_rest ? wall : wall + celerity_ * t + fall;
    return dam_ + fall + 2.0 * celerity_ * t - 3.0 * celerity_ * std::cbrt(meeting * meeting * t);
  }

 private:
  double dam_;           // [m]
  double depth_;         // [m]
  double gravity_;       // [m/s^2]
  double acceleration_;  // [m/s^2]
  double celerity_;      // [m/s] sqrt(G depth)
};

}  // namespace sandsim
