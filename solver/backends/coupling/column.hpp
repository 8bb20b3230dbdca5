// One column of sand and the objects that cover it.
#pragma once

#include "solver/backends/coupling/job.hpp"

namespace sandsim::coupling {

/// The sand of a column before an object acts on it.
template <class R>
struct Column {
  R h = 0, hu = 0, hv = 0;  // what flows: [m], [m^2/s]
  R bed = 0;                // [m] as the flow sees it
  double ground = 0.0;      // [m]
  double buried = 0.0;      // [m]
  bool covered = false;

  SANDSIM_HD double flowing() const { return static_cast<double>(h); }
  SANDSIM_HD bool rests() const { return hu == R(0) && hv == R(0); }
  /// Up to where sand lies on the ground. [m]
  SANDSIM_HD double top() const { return ground + (covered ? buried : flowing()); }
};

template <class R>
SANDSIM_HD Column<R> column_at(const Job<R>& job, int i, int j) {
  const std::ptrdiff_t at = job.state.at(i, j);
  const R bed = job.bed.row(j)[i], ground = job.cover.ground.row(j)[i];
  return {
      job.state.h[at], job.state.hu[at], job.state.hv[at], bed, static_cast<double>(ground), job.cover.buried.row(j)[i],
      bed != ground};
}

/// The objects in a column, from the lowest point of any to the highest.
struct Hull {
  double lowest = objects::endless, highest = -objects::endless;  // [m]
  double overlap = 0.0;                                           // [m] of sand that lies on the ground
  objects::Vec3 velocity;                                         // [m/s] mean over the overlap
  bool still = true, solid = false;
};

/// The sand up to which an object in the column counts as in contact: sand flows into a gap under an object until that
/// is full. What lies on the object counts as long as sand beside it (`highest`) reaches up there: an object that is
/// lifted out of the sand loses what lies on it. [m]
template <class R>
SANDSIM_HD double contact_level(const Column<R>& column, double highest) {
  const double bed = static_cast<double>(column.bed);
  const bool loaded = column.covered && column.h > R(0) && bed <= highest;
  return loaded ? physics::maximum(column.top(), bed) : column.top();
}

/// What covers a column that holds sand up to `level`: nothing that hangs above that.
template <class R>
SANDSIM_HD Hull hull_over(const Job<R>& job, int cell, const Column<R>& column, double level) {
  Hull hull;
  const auto add = [&](const Body& body) {
    if (!body.patch.holds(job.i(cell), job.j(cell)) || !job.is_near(body.lowest, level)) {
      return;
    }
    const Contact contact = job.contact(body, cell, column.ground, column.top());
    if (!job.is_near(contact.lowest, level)) {
      return;
    }
    hull.lowest = physics::minimum(hull.lowest, contact.lowest);
    hull.highest = physics::maximum(hull.highest, contact.highest);
    hull.overlap += contact.overlap;
    hull.velocity = hull.velocity + contact.overlap * contact.velocity;
    hull.still = hull.still && body.still, hull.solid = hull.solid || body.solid;
  };
  add(job.body);
  for (int k = 0; k < job.other_count; ++k) {
    add(job.others[k]);
  }
  if (hull.overlap > 0.0) {
    hull.velocity = (1.0 / hull.overlap) * hull.velocity;
  }
  return hull;
}

/// How a column's sand parts when it is covered.
template <class R>
struct Parting {
  R above = 0;         // [m] stays on top and flows
  double below = 0.0;  // [m] the rest
  double taken = 0.0;  // [m] of that: does not fit under the hull and has to go
};

/// What lies above the hull stays there. A column that was covered already keeps the sand on the object: it goes up and
/// down with it.
template <class R>
SANDSIM_HD Parting<R> part(const Column<R>& column, const Hull& hull) {
  Parting<R> parting{column.h, column.buried, 0.0};
  if (!column.covered) {
    const double above = physics::clamp(column.top() - hull.highest, 0.0, column.flowing());
    parting.above = static_cast<R>(above);
    if (static_cast<double>(parting.above) > above) {  // rounded up: nothing below may become negative
      parting.above = parting.above * (R(1) - physics::unit_rounding<R>);
    }
    parting.below = column.flowing() - static_cast<double>(parting.above);
  }
  const double room = physics::maximum(0.0, hull.lowest - column.ground);
  parting.taken = parting.below - physics::minimum(parting.below, room);
  return parting;
}

/// Sand may run out from under the objects: nothing lies on them, none of it has to go, and beside it stands a free
/// column that is lower by more than a spacing.
template <class R>
SANDSIM_HD bool drains(const Job<R>& job, int i, int j, const Column<R>& column, const Parting<R>& parting) {
  if (parting.above > R(0) || parting.taken > 0.0) {
    return false;
  }
  const int di[4] = {-1, 1, 0, 0}, dj[4] = {0, 0, -1, 1};
  for (int side = 0; side < 4; ++side) {
    const int in = i + di[side], jn = j + dj[side];
    if (in >= 0 && in < job.nx && jn >= 0 && jn < job.ny) {
      const Column<R> next = column_at(job, in, jn);
      if (!next.covered && next.top() < column.top() - job.dx) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace sandsim::coupling
