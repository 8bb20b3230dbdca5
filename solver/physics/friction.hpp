// Coulomb friction: implicit, with an exact zero (eq. 18 and 19).
#pragma once

#include "solver/physics/parameters.hpp"

namespace sandsim::physics {

/// Factor by which friction shortens a vector of length `size` when it can take away `grip`: exactly 0 if the length is
/// no more than `hold`, which may exceed the grip by rounding.
template <class R>
SANDSIM_HD R friction_factor(R size, R grip, R hold) {
  return select(size <= hold, R(0), 1 - grip / size);
}
template <class R>
SANDSIM_HD R friction_factor(R size, R grip) {
  return friction_factor(size, grip, grip);
}

/// What friction holds where it can take away `grip`: that, and the rounding of a push. The push is a sum of some ten
/// terms, and its slope that of depths which are themselves rounded: faces may stay 4 eps h above mu (surface.hpp),
/// four times that is room. `lift` is dt g hbar, the push of a slope of 1. Without friction nothing is held.
template <class R>
SANDSIM_HD R holding(R grip, R lift, R h, R inverse_dx) {
  constexpr Scalar<R> eps = unit_rounding<R>;
  return select(grip > R(0), grip * R(1 + 16 * eps) + lift * (R(16 * eps) * h * inverse_dx), grip);
}

/// Sand that is this much slower than friction could stop in a step has stopped where its slope is below mu. The push
/// of a moving cell contains the jumps at its faces, which its slope does not: without this it may creep for ever.
inline constexpr double creep_fraction = 1.0 / 64.0;

/// A momentum after friction.
template <class R>
struct Slowed {
  R x, y;
};

/// Friction of size `grip` against the momentum (x, y), which was (x_old, y_old) a step before: along the mean of the
/// two directions, which is second order where the flow turns, unless the flow turns by more than a right angle.
/// Exactly 0 where friction holds: up to `hold`.
template <class R>
SANDSIM_HD Slowed<R> slow_down_turning(R x, R y, R x_old, R y_old, R grip, R hold) {
  const R size = length(x, y);
  const auto slides = size > hold;
  if (!any(slides)) {
    return {x * R(0), y * R(0)};  // with the signs that the zeros have below
  }
  const R mean_x = x_old + x, mean_y = y_old + y;
  const R share = grip / length(mean_x, mean_y);
  const auto along_mean = slides & (x_old * x + y_old * y > R(0));
  const R factor = friction_factor(size, grip, hold);
  return {select(along_mean, x - share * mean_x, x * factor), select(along_mean, y - share * mean_y, y * factor)};
}

}  // namespace sandsim::physics
