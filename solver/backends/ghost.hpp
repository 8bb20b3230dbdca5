// What a ghost cell takes from the grid. Wall: mirrored, the normal momentum with its sign changed. Open: the edge cell
// repeated if it flows out and mirrored if it flows in, so that sand leaves and none enters. Periodic: the other side.
#pragma once

#include "solver/physics/math.hpp"
#include "solver/scene.hpp"

namespace sandsim {

/// Index of the cell whose value a ghost cell at distance `k` (1, 2, ...) from a side takes, on a line of n cells.
SANDSIM_HD int ghost_source(BoundaryKind kind, bool high, int k, int n) {
  int from_edge = 0;  // open: the edge cell itself
  if (kind == BoundaryKind::wall) {
    from_edge = physics::minimum(k - 1, n - 1);
  } else if (kind == BoundaryKind::periodic) {
    from_edge = n - 1 - (k - 1) % n;
  }
  return high ? n - 1 - from_edge : from_edge;
}

/// Momentum across the side as the ghost cell has it.
template <class R>
SANDSIM_HD R ghost_momentum(BoundaryKind kind, bool high, R value) {
  switch (kind) {
    case BoundaryKind::wall:
      return -value;
    case BoundaryKind::open:
      return high ? physics::absolute(value) : -physics::absolute(value);
    case BoundaryKind::periodic:
      break;
  }
  return value;
}

/// The cell that a place on a line of n cells, inside or not, takes its values from.
struct Image {
  int index;
  BoundaryKind kind;  // periodic: the value as it is
  bool high;

  template <class R>
  SANDSIM_HD R momentum(R value) const {
    return ghost_momentum(kind, high, value);
  }
};
SANDSIM_HD Image image_of(int i, int n, BoundaryKind low, BoundaryKind high) {
  if (i < 0) {
    return {ghost_source(low, false, -i, n), low, false};
  }
  if (i >= n) {
    return {ghost_source(high, true, i - n + 1, n), high, true};
  }
  return {i, BoundaryKind::periodic, false};
}

}  // namespace sandsim
