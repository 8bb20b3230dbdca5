// The two layers of cells around the grid. Wall: mirrored, the normal momentum with its sign changed. Open: the edge
// cell repeated if it flows out and mirrored if it flows in, so that sand leaves and none enters. Periodic: the other
// side.
#pragma once

#include <algorithm>
#include <cmath>

#include "solver/field.hpp"
#include "solver/scene.hpp"

namespace sandsim::cpu {

/// Index of the cell whose value a ghost cell at distance `k` (1, 2) from a side takes, on a line of n cells.
inline int ghost_source(BoundaryKind kind, bool high, int k, int n) {
  int from_edge = 0;  // open: the edge cell itself
  if (kind == BoundaryKind::wall) {
    from_edge = std::min(k - 1, n - 1);
  } else if (kind == BoundaryKind::periodic) {
    from_edge = n - 1 - (k - 1) % n;
  }
  return high ? n - 1 - from_edge : from_edge;
}

/// Momentum across the side as the ghost cell has it.
template <class R>
R ghost_momentum(BoundaryKind kind, bool high, R value) {
  switch (kind) {
    case BoundaryKind::wall:
      return -value;
    case BoundaryKind::open:
      return high ? std::fabs(value) : -std::fabs(value);
    case BoundaryKind::periodic:
      break;
  }
  return value;
}

/// The grid's size and sides; fills halos.
struct Halo {
  int nx, ny;
  Boundaries sides;

  /// Calls copy(ghost, source, kind, high) for the ghost columns.
  template <class Copy>
  void columns(Copy copy) const {
    for (int k = 1; k <= halo; ++k) {
      copy(-k, ghost_source(sides.x_min, false, k, nx), sides.x_min, false);
      copy(nx - 1 + k, ghost_source(sides.x_max, true, k, nx), sides.x_max, true);
    }
  }
  /// The same for the ghost rows.
  template <class Copy>
  void rows(Copy copy) const {
    for (int k = 1; k <= halo; ++k) {
      copy(-k, ghost_source(sides.y_min, false, k, ny), sides.y_min, false);
      copy(ny - 1 + k, ghost_source(sides.y_max, true, k, ny), sides.y_max, true);
    }
  }

  /// Ghost columns of row j of the state.
  template <class R>
  void fill_columns(const FieldView<R>& h, const FieldView<R>& hu, const FieldView<R>& hv, int j) const {
    R *a = h.row(j), *b = hu.row(j), *c = hv.row(j);
    columns([&](int ghost, int source, BoundaryKind kind, bool high) {
      a[ghost] = a[source];
      b[ghost] = ghost_momentum(kind, high, b[source]);
      c[ghost] = c[source];
    });
  }
  /// Ghost rows of the state, corners included: the columns come first.
  template <class R>
  void fill_rows(const FieldView<R>& h, const FieldView<R>& hu, const FieldView<R>& hv) const {
    rows([&](int ghost, int source, BoundaryKind kind, bool high) {
      const auto copy_row = [&](const FieldView<R>& f) {
        std::copy(f.row(source) - halo, f.row(source) + nx + halo, f.row(ghost) - halo);
      };
      copy_row(h);
      copy_row(hu);
      const R* from = hv.row(source);
      R* to = hv.row(ghost);
      for (int i = -halo; i < nx + halo; ++i) {
        to[i] = ghost_momentum(kind, high, from[i]);
      }
    });
  }

  /// Halo of a material map: the source's value.
  template <class R>
  void fill_map(const FieldView<R>& f) const {
    for (int j = 0; j < ny; ++j) {
      columns([row = f.row(j)](int ghost, int source, BoundaryKind, bool) { row[ghost] = row[source]; });
    }
    rows([&](int ghost, int source, BoundaryKind, bool) {
      std::copy(f.row(source) - halo, f.row(source) + nx + halo, f.row(ghost) - halo);
    });
  }
  /// Halo of the bed: the source's value, and behind an open side the slope goes on.
  template <class R>
  void fill_bed(const FieldView<R>& f) const {
    fill_map(f);
    for (int j = 0; j < ny && nx > 1; ++j) {
      columns([&, row = f.row(j)](int ghost, int source, BoundaryKind kind, bool high) {
        if (kind == BoundaryKind::open) {
          const int inner = high ? source - 1 : source + 1, k = high ? ghost - source : source - ghost;
          row[ghost] = row[source] + static_cast<R>(k) * (row[source] - row[inner]);
        }
      });
    }
    if (ny > 1) {
      rows([&](int ghost, int source, BoundaryKind kind, bool high) {
        const int inner = high ? source - 1 : source + 1, k = high ? ghost - source : source - ghost;
        for (int i = -halo; i < nx + halo; ++i) {
          // The source row again: its own ghost columns may have been extrapolated since.
          const R edge = f.row(source)[i];
          f.row(ghost)[i] = kind == BoundaryKind::open ? edge + static_cast<R>(k) * (edge - f.row(inner)[i]) : edge;
        }
      });
    }
  }
};

}  // namespace sandsim::cpu
