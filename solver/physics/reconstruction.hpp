// What one cell contributes to its faces: limited differences, the half step in time, caps on outflow.
// Balanced scheme; order 2 is MUSCL-Hancock with the MC limiter, order 1 has piecewise constant depth and velocity.
// Symbols: h depth, u v velocity, s surface, b bed; a prefix s (sh, su) is a difference over the cell; d (dh) the
// increment of half a step.
#pragma once

#include "solver/physics/friction.hpp"
#include "solver/physics/hbar.hpp"
#include "solver/physics/surface.hpp"

namespace sandsim::physics {

/// A cell and its two neighbours along one axis, with velocities.
template <class R>
struct Profile3 {
  Line<R> line;
  R u_minus, u_plus, v_minus, v_plus;  // of the neighbours
};

/// Limited differences over the cell along one axis.
template <class R>
struct AxisSlopes {
  R sh, ss, su, sv;
  R G;  // compact slope of the surface along this axis
};

template <class R>
struct CellReconstruction {
  AxisSlopes<R> x, y;
  R G;           // |grad s|
  R demand;      // |q|/(mu hbar): momentum against friction's grip, times g dt
  R dh, du, dv;  // half a step in time
  R Kx, Ky;      // [m/s] caps on the speed of outflow
};

/// The bed slope ss - sh stays within the admissible bed differences, face depths within [h/2, 3h/2].
template <int Order, bool Flat, class R>
SANDSIM_HD AxisSlopes<R> axis_slopes(const Profile3<R>& p, R u, R v, Mask<R> dry, R inverse_dx) {
  const Differences<R> d = differences<Flat>(p.line);
  AxisSlopes<R> out{R(0), R(0), R(0), R(0), compact_slope(d, inverse_dx)};
  R low = R(0), high = R(0);
  if constexpr (!Flat) {
    const R bed = minmod(p.line.b - p.line.b_minus, p.line.b_plus - p.line.b);
    low = minimum(R(0), bed);
    high = maximum(R(0), bed);
    out.ss = clamp(minmod(d.s_minus, d.s_plus), low, high);
  }
  if constexpr (Order == 2) {
    const R h = p.line.h;
    R ss = monotonised_central(d.s_minus, d.s_plus);
    R sh = ss;
    if constexpr (!Flat) {
      sh = clamp(monotonised_central(d.h_minus, d.h_plus), ss - high, ss - low);
    }
    sh = clamp(sh, -h, h);
    ss = Flat ? sh : sh + clamp(ss - sh, low, high);
    out.ss = select(dry, out.ss, ss);
    out.sh = select(dry, R(0), sh);
    const R su = monotonised_central(u - p.u_minus, p.u_plus - u);
    const R sv = monotonised_central(v - p.v_minus, p.v_plus - v);
    out.su = select(dry, R(0), su);
    out.sv = select(dry, R(0), sv);
  }
  return out;
}

/// Hancock's half step in primitive variables with implicit friction.
template <class R>
SANDSIM_HD void predict(CellReconstruction<R>& c, R h, R u, R v, Mask<R> dry, const Material<R>& m,
                        const StepParameters<R>& p) {
  const R half = R(0.5f);
  const R lowest =
      minimum(minimum(h + half * c.x.sh, h - half * c.x.sh), minimum(h + half * c.y.sh, h - half * c.y.sh));
  const R half_ratio = half * p.ratio;
  const R growth = -half_ratio * ((u * c.x.sh + h * c.x.su) + (v * c.y.sh + h * c.y.sv));
  const R dh = maximum(growth, -half * lowest);
  const R ratio = hbar(h, m) / h;
  const auto held = (u == R(0)) & (v == R(0)) & (c.G <= m.mu);
  const R force_x = select(held, R(0), p.g * ratio * c.x.ss);
  const R force_y = select(held, R(0), p.g * ratio * c.y.ss);
  const R w = u - half_ratio * (u * c.x.su + v * c.y.su + force_x);
  const R z = v - half_ratio * (u * c.x.sv + v * c.y.sv + force_y);
  const R factor = friction_factor(length(w, z), half * p.dt * m.mu * p.g * ratio);
  c.dh = select(dry, R(0), dh);
  c.du = select(dry, R(0), w * factor - u);
  c.dv = select(dry, R(0), z * factor - v);
}

/// OneD: the y axis has no neighbours and no faces.
template <int Order, bool Flat, bool OneD, class R>
SANDSIM_HD CellReconstruction<R> reconstruct(const Profile3<R>& along_x, const Profile3<R>& along_y, R u, R v,
                                             const Material<R>& m, const StepParameters<R>& p) {
  const R h = along_x.line.h;
  const Mask<R> dry = h <= p.dry_depth;
  CellReconstruction<R> c;
  c.x = axis_slopes<Order, Flat>(along_x, u, v, dry, p.inverse_dx);
  if constexpr (OneD) {
    c.y = {R(0), R(0), R(0), R(0), R(0)};
    c.G = absolute(c.x.G);
  } else {
    c.y = axis_slopes<Order, Flat>(along_y, u, v, dry, p.inverse_dx);
    c.G = length(c.x.G, c.y.G);
  }
  const R thickness = hbar(h, m);
  const R speed = OneD ? absolute(u) : length(u, v);
  const R demand = speed * h / (m.mu * thickness);
  c.demand = select(h > p.dry_depth, demand, R(0));

  // Outflow over all faces stays under 0.9998 h for any step, so that no depth becomes negative.
  const R wave = square_root(p.g * thickness);
  const R K = constant<R>(0.4999) * p.cell_a_step;
  if constexpr (OneD) {
    c.Kx = K;
    c.Ky = R(0);
  } else {
    const R a_x = absolute(u) + wave, a_y = absolute(v) + wave, sum = a_x + a_y;
    // True quotients: they are exactly 1/2 in still sand, so that a lake's neighbours have the same caps.
    c.Kx = K * select(sum > R(0), a_x / sum, R(0.5f));
    c.Ky = K * select(sum > R(0), a_y / sum, R(0.5f));
  }
  c.dh = c.du = c.dv = R(0);
  if constexpr (Order == 2) {
    if (!every(dry)) {
      predict(c, h, u, v, dry, m, p);
    }
  }
  return c;
}

}  // namespace sandsim::physics
