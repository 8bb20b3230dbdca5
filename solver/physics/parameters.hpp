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
  // Quotients of the above: a division costs ten times a multiplication.
  R inverse_dx;    // [1/m]
  R ratio;         // [s/m] dt/dx
  R cell_a_step;   // [m/s] dx/dt
  R inverse_g_dt;  // [s/m] 1/(g dt)
};

/// Fills in the quotients. A step of 0 is for uses that have none (they do not look at the quotients with dt).
template <class R>
SANDSIM_HD StepParameters<R> step_parameters(R dx, R g, R dt, R dry_depth) {
  return {dx, g, dt, dry_depth, 1 / dx, dt / dx, dx / dt, 1 / (g * dt)};
}

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
