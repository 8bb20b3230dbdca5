// hbar: depth of the dilute layer, the part of a column that the pressure acts on (eq. 2, 3 and section 3.1).
#pragma once

#include "solver/physics/parameters.hpp"

namespace sandsim::physics {

/// hbar = min(alpha h, cap). [m]
template <class R>
SANDSIM_HD R hbar(R h, const Material<R>& material) {
  return minimum(material.alpha * h, material.cap);
}

/// Mean of hbar over the depths between p and q: (Phi(q) - Phi(p))/(q - p) with Phi' = hbar, without cancellation. [m]
template <class R>
SANDSIM_HD R mean_hbar(R p, R q, const Material<R>& material) {
  const R low = minimum(p, q), high = maximum(p, q);
  const R kink = material.cap / material.alpha;  // depth at which the cap sets in
  const R under = material.alpha * (low + high) * R(0.5f);
  if (every(high <= kink)) {
    return under;
  }
  const R below = kink - low;
  const R across = material.cap - material.alpha * below * below / (2 * (high - low));
  return select(high <= kink, under, select(low >= kink, material.cap, across));
}

}  // namespace sandsim::physics
