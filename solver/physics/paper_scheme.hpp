// The scheme of the paper's section 4 as printed, with the switches of its errata.
// Where the print cannot be run: eq. 8 takes a plus between the axes (volume), eq. 11 takes delta in the limit of 0 and
// in the denominator only (no flux between dry cells).
#pragma once

#include "solver/physics/balanced_update.hpp"
#include "solver/physics/friction.hpp"
#include "solver/physics/hbar.hpp"

namespace sandsim::physics {

/// Chosen once a run.
template <class R>
struct PaperSwitches {
  R flux_factor;      // 1: hu^2; 1/2: as eq. 7 prints it
  Mask<R> rest_gate;  // no flux through a face whose two normal velocities are exactly 0
};

/// Depth and velocities of one side of a face, n across and t along it.
template <class R>
struct PaperSide {
  R h, n, t;
};

/// Eq. 11 and 12.
template <class R>
SANDSIM_HD FaceFlux<R> paper_flux(const PaperSide<R>& L, const PaperSide<R>& Q, const PaperSwitches<R>& switches, R g) {
  const R c_left = square_root(g * L.h), c_right = square_root(g * Q.h);
  const R a_plus = maximum(maximum(L.n + c_left, Q.n + c_right), R(0));
  const R a_minus = minimum(minimum(L.n - c_left, Q.n - c_right), R(0));
  const R width = a_plus - a_minus, product = a_plus * a_minus;
  const R q_left = L.h * L.n, q_right = Q.h * Q.n, r_left = L.h * L.t, r_right = Q.h * Q.t;
  const auto closed = (width <= R(0)) | (switches.rest_gate & (L.n == R(0)) & (Q.n == R(0)));
  // One reciprocal serves the three components.
  const R weight = select(closed, R(0), 1 / width);
  FaceFlux<R> F;
  F.mass = (a_plus * q_left - a_minus * q_right + product * (Q.h - L.h)) * weight;
  F.normal =
      (switches.flux_factor * (a_plus * (q_left * L.n) - a_minus * (q_right * Q.n)) + product * (q_right - q_left)) *
      weight;
  F.transverse = (a_plus * (q_left * L.t) - a_minus * (q_right * Q.t) + product * (r_right - r_left)) * weight;
  F.jump_left = F.jump_right = R(0);
  return F;
}

/// Eq. 8, 9, 10, 17 and 19. `velocity` is that of eq. 13, from which the momentum is recomputed; slopes are the central
/// differences of s over two cells.
template <bool OneD, class R>
SANDSIM_HD State<R> paper_update(R h, R u, R v, R surface_west_east, R surface_south_north, const FaceFlux<R>& west,
                                 const FaceFlux<R>& east, const FaceFlux<R>& south, const FaceFlux<R>& north,
                                 const Material<R>& m, const StepParameters<R>& p) {
  const R k = p.ratio;
  const NetFlow<R> flow = net_flow<OneD>(west, east, south, north);
  const R thickness = hbar(h, m);
  const R push = R(0.5f) * p.g * thickness;
  R hu = h * u - k * (flow.x + push * surface_west_east);
  R hv = h * v - k * (flow.y + push * surface_south_north);
  const R grip = p.dt * m.mu * p.g * thickness;
  const R factor = friction_factor(OneD ? absolute(hu) : length(hu, hv), grip);
  // Without friction a cell at rest has size = grip = 0 and the factor is 0, which is right as well.
  hu = hu * factor;
  hv = hv * factor;
  const R h_new = h - k * flow.mass;
  const auto dries = h_new <= p.dry_depth;
  return {h_new, select(dries, R(0), hu), select(dries, R(0), hv)};
}

}  // namespace sandsim::physics
