// The two layers of ghost cells around the grid, as stored beside it.
#pragma once

#include <algorithm>
#include <vector>

#include "solver/backends/cover.hpp"
#include "solver/field.hpp"

namespace sandsim {

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
  /// Halo of a bed that objects cover: covered like the source, else as the ground's.
  template <class R>
  void fill_covered_bed(const FieldView<R>& bed, const FieldView<R>& ground) const {
    for (int k = 0; k < ring_cells(nx, ny); ++k) {
      renew_ring_bed(bed, ground, sides, nx, ny, k);
    }
  }
};

/// A map of the grid (x fastest) with its halo; a single value as one repeated row.
template <class R>
Field<R> stored_map(const std::vector<double>& values, const Halo& sides) {
  if (values.size() == 1) {
    return Field<R>(sides.nx, sides.ny, static_cast<R>(values.front()), true);
  }
  Field<R> field(sides.nx, sides.ny, R(0));
  auto value = values.begin();
  for (int j = 0; j < sides.ny; ++j) {
    std::transform(value, value + sides.nx, field.row(j), [](double v) { return static_cast<R>(v); });
    value += sides.nx;
  }
  sides.fill_map(field.view());
  return field;
}
/// The same for the bed, which may be empty: flat. With `in_full` no row is repeated.
template <class R>
Field<R> stored_bed(const std::vector<double>& values, const Halo& sides, bool in_full) {
  if (values.empty()) {
    return Field<R>(sides.nx, sides.ny, R(0), !in_full);
  }
  Field<R> field = stored_map<R>(values, sides);
  if (values.size() > 1) {
    sides.fill_bed(field.view());
  }
  return field;
}

}  // namespace sandsim
