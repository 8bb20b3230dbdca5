// Coulomb friction: implicit, with an exact zero (eq. 18 and 19).
#pragma once

#include "solver/physics/parameters.hpp"

namespace sandsim::physics {

/// Factor by which friction shortens a vector of length `size` when it can take away `grip`: exactly 0 if it holds.
template <class R>
SANDSIM_HD R friction_factor(R size, R grip) {
  return select(size <= grip, R(0), 1 - grip / size);
}

}  // namespace sandsim::physics
