// What the tile kernels read and write, as plain pointers and numbers.
#pragma once

#include <cstddef>

#include "solver/backends/cover.hpp"
#include "solver/field.hpp"
#include "solver/physics/parameters.hpp"

namespace sandsim::tiles {

/// A state without ghost cells: those are images of cells inside, taken when a tile is read.
template <class R>
struct StateView {
  R *h = nullptr, *hu = nullptr, *hv = nullptr;
  std::ptrdiff_t stride = 0;

  SANDSIM_HD std::ptrdiff_t at(int i, int j) const { return j * stride + i; }
};

/// Mass fluxes [m^2/s] out of open sides in a step, one a face; null where the side is closed.
struct SideMass {
  double *x_min = nullptr, *x_max = nullptr, *y_min = nullptr, *y_max = nullptr;
};

/// The fields of a run on its grid. The present state is states 0 or 1, the other one is written.
template <class R>
struct TileFields {
  int nx = 0, ny = 0;
  Boundaries sides;
  R dx = 0, g = 0, dry_depth = 0;
  double spacing = 0.0;  // [m] the scene's, for volumes
  StateView<R> states[2];
  FieldView<R> bed;             // with its halo; not read where the terrain is flat
  Cover<R> cover;               // of the bed; none without covering objects
  FieldView<R> mu, alpha, cap;  // with their halo; not read where the material is uniform
  physics::Material<R> material;
  SideMass out;

  /// Without indexing by a variable, which would put the views into slow memory on a device.
  SANDSIM_HD const StateView<R>& state(int which) const { return which == 0 ? states[0] : states[1]; }
  SANDSIM_HD Image column(int i) const { return image_of(i, nx, sides.x_min, sides.x_max); }
  SANDSIM_HD Image row(int j) const { return image_of(j, ny, sides.y_min, sides.y_max); }
  /// Where the bed and the maps of a place are stored: on the other side of a periodic grid, else in the halo.
  SANDSIM_HD int stored_column(int i) const { return stored(i, nx, sides.x_min, sides.x_max); }
  SANDSIM_HD int stored_row(int j) const { return stored(j, ny, sides.y_min, sides.y_max); }

  SANDSIM_HD physics::StepParameters<R> parameters(R dt) const {
    return physics::step_parameters(dx, g, dt, dry_depth);
  }
  template <bool Uniform>
  SANDSIM_HD physics::Material<R> material_at(int i, int j) const {
    if constexpr (Uniform) {
      return material;
    } else {
      return {mu.row(j)[i], alpha.row(j)[i], cap.row(j)[i]};
    }
  }

 private:
  SANDSIM_HD static int stored(int i, int n, BoundaryKind low, BoundaryKind high) {
    const Image image = image_of(i, n, low, high);
    return image.kind == BoundaryKind::periodic ? image.index : physics::clamp(i, -halo, n - 1 + halo);
  }
};

/// Cells [i0, i1) of rows [j0, j1): what a strip of threads writes.
struct TileBounds {
  int i0, i1, j0, j1;

  SANDSIM_HD bool holds(int i, int j) const { return i >= i0 && i < i1 && j >= j0 && j < j1; }
};

/// What a thread brings out of a tile.
template <class R>
struct TileOutcome {
  R fastest = 0;  // [m/s] over its new cells
  int bits = 0;
};

/// Bits that a step collects over its cells.
enum StepBit : int { bit_moving = 1, bit_changed = 2, bit_broken = 4 };

/// What a new cell says of the step.
template <class R>
SANDSIM_HD int step_bits(R h_old, R hu_old, R hv_old, R h, R hu, R hv) {
  const R largest = physics::largest_number<R>;
  const bool sound = h >= R(0) && h <= largest && physics::absolute(hu) + physics::absolute(hv) <= largest;
  return ((hu != R(0)) | (hv != R(0)) ? bit_moving : 0) |
         ((h != h_old) | (hu != hu_old) | (hv != hv_old) ? bit_changed : 0) | (sound ? 0 : bit_broken);
}

/// Takes out of a face of an open side a flux inwards. Returns the mass that flows outwards. [m^2/s]
template <class Flux>
SANDSIM_HD double pass_outwards(Flux& flux, bool high) {
  if (high ? flux.mass < 0 : flux.mass > 0) {
    flux.mass = flux.normal = flux.transverse = 0;
  }
  return high ? static_cast<double>(flux.mass) : -static_cast<double>(flux.mass);
}

}  // namespace sandsim::tiles
