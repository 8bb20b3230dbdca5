// The scheme's own numbers that a scene may leave out.
#pragma once

#include "solver/scene.hpp"

namespace sandsim {

/// Courant number if the scene gives none. Balanced: numerics.md (flat in error per cost around these); paper: the
/// C of eq. 34, beside the 1/4 of eq. 14.
inline double default_courant(const Numerics& numerics) {
  if (numerics.scheme == Scheme::paper) {
    return 0.25;
  }
  return numerics.order == 2 ? 0.6 : 0.9;
}

}  // namespace sandsim
