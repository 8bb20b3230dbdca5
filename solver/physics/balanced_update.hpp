// One cell's new depth and momentum from its faces: balanced scheme.
#pragma once

#include "solver/physics/balanced_flux.hpp"
#include "solver/physics/reconstruction.hpp"

namespace sandsim::physics {

/// Conserved state of a cell.
template <class R>
struct State {
  R h, hu, hv;  // [m], [m^2/s]
};

/// What leaves a cell through its faces: mass and momentum along x and y.
template <class R>
struct NetFlow {
  R mass, x, y;
};

/// The pairs are summed first, then the axes: mirrored and turned states give mirrored and turned results.
template <bool OneD, class R>
SANDSIM_HD NetFlow<R> net_flow(const FaceFlux<R>& west, const FaceFlux<R>& east, const FaceFlux<R>& south,
                               const FaceFlux<R>& north) {
  NetFlow<R> net{east.mass - west.mass, east.normal - west.normal, east.transverse - west.transverse};
  if constexpr (!OneD) {
    net.mass = net.mass + (north.mass - south.mass);
    net.x = net.x + (north.transverse - south.transverse);
    net.y = net.y + (north.normal - south.normal);
  }
  return net;
}

/// The parts of a reconstruction that the update needs again.
template <class R>
struct CellCore {
  R sh_x, ss_x, sh_y, ss_y, dh, G;
};

/// The friction of order 2 acts along the mean direction of the step, that of order 1 along the new one.
template <int Order, bool OneD, class R>
SANDSIM_HD State<R> balanced_update(const State<R>& old, const CellCore<R>& c, const FaceFlux<R>& west,
                                    const FaceFlux<R>& east, const FaceFlux<R>& south, const FaceFlux<R>& north,
                                    const Material<R>& m, const StepParameters<R>& p) {
  const R half = R(0.5f), zero = R(0), k = p.ratio;
  const R h = old.h;
  const NetFlow<R> flow = net_flow<OneD>(west, east, south, north);
  const R h_new = h - k * flow.mass;

  const auto wet = h > p.dry_depth;
  const R lift = p.dt * p.g * hbar(h + c.dh, m), grip = p.dt * m.mu * p.g * hbar(h + c.dh, m);
  const R hold = holding(grip, lift, h, p.inverse_dx), creep = constant<R>(creep_fraction) * grip;
  const auto held = wet & (maximum(absolute(old.hu), absolute(old.hv)) <= creep) & (c.G <= m.mu);
  const R h_east = h + half * c.sh_x + c.dh, h_west = h - half * c.sh_x + c.dh;
  R push_x = p.g * mean_hbar(h_east, h_west, m) * c.ss_x + (east.jump_left + west.jump_right);
  R push_y = zero;
  if constexpr (!OneD) {
    const R h_north = h + half * c.sh_y + c.dh, h_south = h - half * c.sh_y + c.dh;
    push_y = p.g * mean_hbar(h_north, h_south, m) * c.ss_y + (north.jump_left + south.jump_right);
  }
  push_x = select(held, zero, push_x);
  push_y = select(held, zero, push_y);

  // The push may not do more work than lifting over one cell.
  const R push = (OneD ? absolute(push_x) : length(push_x, push_y)) * p.inverse_dx;
  const R most = 2 * p.dx * maximum(h, h_new);
  const auto wild = wet & (push * p.dt * p.dt > most);
  if (any(wild)) {
    const R tame = select(wild, square_root(most / push) / p.dt, R(1));
    push_x = push_x * tame;
    push_y = push_y * tame;
  }

  R hu = old.hu - k * (flow.x + push_x), hv = old.hv - k * (flow.y + push_y);
  if constexpr (Order == 2) {
    const Slowed<R> slowed = slow_down_turning(hu, hv, old.hu, old.hv, grip, hold);
    hu = slowed.x;
    hv = slowed.y;
  } else {
    const R factor = friction_factor(OneD ? absolute(hu) : length(hu, hv), grip, hold);
    hu = hu * factor;
    hv = hv * factor;
  }

  // No more than one cell a step; acts only when a fixed step breaks the bound.
  const R fastest = h_new * p.cell_a_step, size_new = OneD ? absolute(hu) : length(hu, hv);
  const auto leaps = size_new > fastest;
  if (any(leaps)) {
    const R slow = select(leaps, fastest / size_new, R(1));
    hu = hu * slow;
    hv = hv * slow;
  }
  const auto dries = h_new <= p.dry_depth;
  return {h_new, select(dries, zero, hu), select(dries, zero, hv)};
}

}  // namespace sandsim::physics
