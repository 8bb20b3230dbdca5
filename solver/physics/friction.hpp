// Coulomb friction: implicit, with an exact zero (eq. 18 and 19).
#pragma once

#include "solver/physics/parameters.hpp"

namespace sandsim::physics {

/// Factor by which friction shortens a vector of length `size` when it can take away `grip`: exactly 0 if it holds.
template <class R>
SANDSIM_HD R friction_factor(R size, R grip) {
  return select(size <= grip, R(0), 1 - grip / size);
}

/// A momentum after friction.
template <class R>
struct Slowed {
  R x, y;
};

/// Friction of size `grip` against the momentum (x, y), which was (x_old, y_old) a step before: along the mean of the
/// two directions, which is second order where the flow turns, unless the flow turns by more than a right angle.
/// Exactly 0 if friction holds.
template <class R>
SANDSIM_HD Slowed<R> slow_down_turning(R x, R y, R x_old, R y_old, R grip) {
  const R size = length(x, y);
  const auto slides = size > grip;
  if (!any(slides)) {
    return {x * R(0), y * R(0)};  // with the signs that the zeros have below
  }
  const R mean_x = x_old + x, mean_y = y_old + y;
  const R share = grip / length(mean_x, mean_y);
  const auto along_mean = slides & (x_old * x + y_old * y > R(0));
  const R factor = friction_factor(size, grip);
  return {select(along_mean, x - share * mean_x, x * factor), select(along_mean, y - share * mean_y, y * factor)};
}

}  // namespace sandsim::physics
