// The numbers that are the same for every cell in a step.
#pragma once

#include "solver/physics/math.hpp"

namespace sandsim::physics {

/// Constants of one step. R is float or double.
template <class R>
struct StepParameters {
  R dx;         // [m] spacing
  R g;          // [m/s^2]
  R dt;         // [s]
  R dry_depth;  // [m] below it a cell carries no momentum
};

/// What the sand is made of in one cell: hbar = min(alpha h, cap).
template <class R>
struct Material {
  R mu;     // [-] friction coefficient
  R alpha;  // [-]
  R cap;    // [m]
};

/// Depth below which a cell carries no momentum, as a fraction of the spacing (numerics.md, "Reconstruction").
inline constexpr double dry_depth_fraction = 1e-8;

}  // namespace sandsim::physics
