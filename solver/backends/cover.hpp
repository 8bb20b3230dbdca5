// What lies under objects that sand must not enter. A covered column has two lots of sand: what is buried between the
// object and the ground and held there, and what lies on top of the object and flows. For the flow the object is bed.
#pragma once

#include "solver/backends/ghost.hpp"
#include "solver/field.hpp"

namespace sandsim {

/// Views of the ground and of the buried sand; both null where a scene has no such objects.
template <class R>
struct Cover {
  FieldView<R> ground;       // [m] the terrain, with its halo
  FieldView<double> buried;  // [m] of sand; 0 where a column is not covered

  SANDSIM_HD bool none() const { return buried.origin == nullptr; }
  SANDSIM_HD double buried_at(int i, int j) const { return none() ? 0.0 : buried.row(j)[i]; }
  /// Depth of all the sand of a column, of which h flows. [m]
  SANDSIM_HD R depth(int i, int j, R h) const {
    return none() ? h : static_cast<R>(static_cast<double>(h) + buried.row(j)[i]);
  }
  /// The terrain where the flow sees `bed`. [m]
  SANDSIM_HD R terrain(int i, int j, R bed) const { return none() ? bed : ground.row(j)[i]; }
  /// Height of the sand, which is that of the ground where there is none; in double, for of a bed far from 0 an R
  /// would round the depth away. [m]
  SANDSIM_HD double surface(int i, int j, R h, R bed) const {
    const bool on_top = none() || h > R(0) || bed == ground.row(j)[i];
    const R above = on_top ? h : static_cast<R>(buried.row(j)[i]);
    return static_cast<double>(above) + static_cast<double>(on_top ? bed : ground.row(j)[i]);
  }
};

/// Cells of the halo's ring around a grid, and the place of the k-th of them.
SANDSIM_HD int ring_cells(int nx, int ny) {
  return 2 * halo * (nx + 2 * halo + ny);
}
SANDSIM_HD void ring_place(int k, int nx, int ny, int& i, int& j) {
  const int width = nx + 2 * halo, rows = 2 * halo * width;
  if (k < rows) {
    i = k % width - halo, j = k / width;
    j = j < halo ? j - halo : ny + j - halo;
  } else {
    i = (k - rows) % (2 * halo), j = (k - rows) / (2 * halo);
    i = i < halo ? i - halo : nx + i - halo;
  }
}

/// The bed in cell k of the ring follows the column that it is the image of: covered like that one, else terrain.
template <class R>
SANDSIM_HD void renew_ring_bed(const FieldView<R>& bed, const FieldView<R>& ground, const Boundaries& sides, int nx,
                               int ny, int k) {
  int i, j;
  ring_place(k, nx, ny, i, j);
  const int from_i = image_of(i, nx, sides.x_min, sides.x_max).index;
  const int from_j = image_of(j, ny, sides.y_min, sides.y_max).index;
  const R source = bed.row(from_j)[from_i];
  bed.row(j)[i] = source == ground.row(from_j)[from_i] ? ground.row(j)[i] : source;
}

}  // namespace sandsim
