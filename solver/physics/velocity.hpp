// From momentum to velocity.
#pragma once

#include "solver/physics/parameters.hpp"

namespace sandsim::physics {

/// u = hu/h, and 0 where the cell is dry. [m/s]
template <class R>
SANDSIM_HD R quotient_velocity(R momentum, R h, R dry_depth) {
  const R u = momentum / h;
  return select(h <= dry_depth, R(0), u);
}

/// Eq. 13: u = sqrt(2) h (hu) / sqrt(h^4 + max(h^4, dx^4)). [m/s]
template <class R>
SANDSIM_HD R desingularised_velocity(R momentum, R h, R inverse_dx) {
  // Divided through by dx^4: h^4 alone leaves the range of float32 for layers that are thin or deep.
  const R ratio = h * inverse_dx, ratio2 = ratio * ratio, ratio4 = ratio2 * ratio2;
  return constant<R>(1.4142135623730951) * ratio * (momentum * inverse_dx) /
         square_root(ratio4 + maximum(ratio4, R(1)));
}

}  // namespace sandsim::physics
