// The flux of the balanced scheme through one face, with the pressure as a jump on either side.
// L and R are the cells on the minus and the plus side; "normal" is across the face, "transverse" along it.
#pragma once

#include "solver/physics/hbar.hpp"
#include "solver/physics/surface.hpp"

namespace sandsim::physics {

/// One side of a face: the cell's reconstruction along the face's axis.
template <class R>
struct FaceSide {
  R h, b;        // of the cell
  R normal;      // [m/s] velocity at the face, half a step on
  R transverse;  // [m/s]
  R sh, ss;      // differences over the cell along the axis
  R dh;
  R demand;
  R K;
  Material<R> material;
};

/// Mass, normal and transverse momentum through the face, and the pressure's jumps as L and as R see them.
template <class R>
struct FaceFlux {
  R mass, normal, transverse, jump_left, jump_right;
};

/// What friction has to hold at a face: see surface_drop(). Flat: the bed is not looked at. [m]
template <bool Flat, class R>
SANDSIM_HD R face_drop(const FaceSide<R>& L, const FaceSide<R>& Q, R surface_jump) {
  if constexpr (Flat) {
    return absolute(surface_jump);
  } else {
    return surface_drop(surface_jump, L.h, Q.h, L.b, Q.b);
  }
}

/// What static friction makes of a face.
template <class R>
struct FrictionHold {
  R phi;     // fraction of the acoustic dissipation: 0 where friction holds the face, 1 in flow
  R topple;  // [m^2/s] mass that a face at rest but a little steeper than mu lets slide down
};

/// A face may stay above mu between two cells that are held, since the cells' own slopes are means over two faces. Its
/// excess then fades ever more slowly (phi goes with the excess) and, in float32, stops at rounding. So a quarter of
/// an excess of up to 1 % slides down in each step: the largest share that leaves a peak between four faces above mu
/// no lower than its neighbours' mirror image. Steeper faces are left to the dynamics.
template <class R>
SANDSIM_HD FrictionHold<R> friction_hold(const FaceSide<R>& L, const FaceSide<R>& Q, R drop,
                                         const StepParameters<R>& p) {
  const R mu = minimum(L.material.mu, Q.material.mu);
  const R held = mu * p.dx;
  const auto stands = drop <= held;
  const R share = every(stands) ? R(1) : select(stands, R(1), held / drop);
  const R demand = maximum(L.demand, Q.demand);
  const R stillness = maximum(R(0), 1 - demand * p.inverse_g_dt);
  const auto topples = (mu > R(0)) & (demand == R(0)) & (drop > held) & (drop <= constant<R>(1.01) * held);
  return {select(mu > R(0), 1 - share * stillness, R(1)),
          select(topples, R(0.25f) * (drop - held) * p.cell_a_step, R(0))};
}

/// Between two materials a face may stay above the smaller mu, since the rougher cell is held by its own: the other one
/// then pushes against a slope that its reconstruction does not see, for ever. There the excess goes at the speed of
/// the waves, as first order has it, while the sand creeps: at up to four steps' worth of friction. An excess of no
/// more than the rounding of the depths stays. [m^2/s]
template <class R>
SANDSIM_HD R slump_between_materials(const FaceSide<R>& L, const FaceSide<R>& Q, R drop, R wave,
                                     const StepParameters<R>& p) {
  const R demand = maximum(L.demand, Q.demand);
  const R creep = maximum(R(0), 1 - R(0.25f) * demand * p.inverse_g_dt);
  const R mu = minimum(L.material.mu, Q.material.mu);
  const R rounding = R(2 * unit_rounding<R>) * (L.h + Q.h);
  return select(mu > R(0), R(0.5f) * wave * creep * maximum(R(0), drop - mu * p.dx - rounding), R(0));
}

template <bool Flat, class R>
SANDSIM_HD FaceFlux<R> balanced_flux(const FaceSide<R>& L, const FaceSide<R>& Q, const StepParameters<R>& p) {
  const R half = R(0.5f), zero = R(0);
  if (every((L.h <= zero) & (Q.h <= zero))) {
    return {zero, zero, zero, zero, zero};
  }
  // Depths at the face, and above the higher of the two beds there.
  const R surface_jump = surface_difference(L.h, Q.h, L.b, Q.b);
  const R h_left0 = L.h + half * L.sh, h_right0 = Q.h - half * Q.sh;
  const R h_left = h_left0 + L.dh, h_right = h_right0 + Q.dh;
  const R ds = surface_jump - half * (L.ss + Q.ss) + (Q.dh - L.dh);
  const R beta = ds - (h_right - h_left);  // jump of the bed at the face
  const R x_left = minimum(select(beta > zero, maximum(zero, h_right - ds), h_left), h_left);
  const R x_right = minimum(select(beta < zero, maximum(zero, h_left + ds), h_right), h_right);

  // A side without sand takes the other's velocity.
  const R u_left = select(x_left <= zero, Q.normal, L.normal);
  const R u_right = select(x_right <= zero, u_left, Q.normal);
  const R c_left = square_root(p.g * hbar(x_left, L.material));
  const R c_right = square_root(p.g * hbar(x_right, Q.material));
  const R a_plus = maximum(maximum(u_left + c_left, u_right + c_right), zero);
  const R a_minus = minimum(minimum(u_left - c_left, u_right - c_right), zero);
  const R drop = face_drop<Flat>(L, Q, surface_jump);
  const FrictionHold<R> hold = friction_hold(L, Q, drop, p);
  const R phi = hold.phi;
  const R b_plus = maximum(maximum(u_left + phi * c_left, u_right + phi * c_right), zero);
  const R b_minus = minimum(minimum(u_left - phi * c_left, u_right - phi * c_right), zero);

  // HLL as two upwind transports: each side sends its depth out at its own speed, capped so that no depth becomes
  // negative.
  const R width = b_plus - b_minus;
  const R per_width = 1 / width;
  const auto flows = width > zero;
  const R cap_left = L.K * minimum(h_left0, x_left), cap_right = Q.K * minimum(h_right0, x_right);
  const R out_left = b_plus * (u_left - b_minus) * per_width * x_left;
  const R out_right = -b_minus * (b_plus - u_right) * per_width * x_right;
  const R m_left = minimum(select(flows, out_left, zero), cap_left);
  const R m_right = minimum(select(flows, out_right, zero), cap_right);
  const auto leftward = surface_jump > zero;
  R topple = hold.topple;
  const auto differ = L.material.mu != Q.material.mu;
  if (any(differ)) {
    const R slump = slump_between_materials(L, Q, drop, maximum(c_left, c_right), p);
    const R downhill = select(leftward, m_right - m_left, m_left - m_right);
    topple = select(differ, select(slump > zero, maximum(zero, slump - downhill), zero), topple);
  }
  // The slide takes what the caps leave.
  const R slide = minimum(topple, select(leftward, cap_right - m_right, cap_left - m_left));

  FaceFlux<R> F;
  F.mass = (m_left - m_right) + select(leftward, -slide, slide);
  F.normal = m_left * u_left - m_right * u_right;
  // A trickle below the rounding of the depth that it comes from would not lower it: a spring that never runs dry.
  const auto still = (u_left == zero) & (u_right == zero);
  const R trickle = select(still, absolute(F.mass), m_left + m_right + slide);
  const auto dries_up = trickle * p.ratio < R(unit_rounding<R> / 2) * select(F.mass > zero, L.h, Q.h);
  F.mass = select(dries_up, zero, F.mass);
  F.normal = select(dries_up, zero, F.normal);
  F.transverse = F.mass * select(F.mass > zero, L.transverse, Q.transverse);

  // Pressure: g hbar times the jump, shared between the sides by the wave speeds.
  const R spread = a_plus - a_minus;
  const R per_spread = every(phi == R(1)) ? per_width : 1 / spread;
  const auto connected =
      ((beta >= zero) & (x_left < h_left) & (x_left > zero)) | ((beta < zero) & (x_right < h_right) & (x_right > zero));
  const R jump = select(connected, ds, x_right - x_left);
  // Where the materials differ the thinner dilute layer transmits the pressure: dense sand does not push. The other
  // layer's force would drive a thin neighbour without bound.
  const R H = minimum(mean_hbar(x_left, x_right, L.material), mean_hbar(x_left, x_right, Q.material));
  const R held_left = phi * H + (1 - phi) * minimum(H, 2 * hbar(L.h, L.material));
  const R held_right = phi * H + (1 - phi) * minimum(H, 2 * hbar(Q.h, Q.material));
  const R jump_left = p.g * (-a_minus * per_spread * select(phi != R(1), held_left, H)) * jump;
  const R jump_right = p.g * (a_plus * per_spread * select(phi != R(1), held_right, H)) * jump;

  const auto empty = (x_left <= zero) & (x_right <= zero);
  F.mass = select(empty, zero, F.mass);
  F.normal = select(empty, zero, F.normal);
  F.transverse = select(empty, zero, F.transverse);
  F.jump_left = select(empty | (spread <= zero), zero, jump_left);
  F.jump_right = select(empty | (spread <= zero), zero, jump_right);
  return F;
}

}  // namespace sandsim::physics
