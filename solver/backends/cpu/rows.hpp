// What the row kernels of both schemes share: views of the fields, scratch rows, tiles.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "solver/field.hpp"
#include "solver/physics/parameters.hpp"

namespace sandsim::cpu {

/// Everything that a step reads and writes.
template <class R>
struct StepFields {
  FieldView<R> h, hu, hv;              // present state
  FieldView<R> h_new, hu_new, hv_new;  // written
  FieldView<R> bed;                    // not read where the terrain is flat
  FieldView<R> mu, alpha, cap;         // not read where the material is uniform
  physics::Material<R> material;       // where it is uniform
};

/// Columns [i0, i1) of rows [j0, j1).
struct Tile {
  int i0, i1, j0, j1;
};

/// Bits that a step collects over its cells.
enum StepFlag : int { moving = 1, changed = 2, broken = 4 };

/// Mass fluxes [m^2/s] through the faces of open sides, one value a face; a closed side's pointer is null. They are
/// summed after the step, in the order of rows and columns.
struct SideFlow {
  double *x_min = nullptr, *x_max = nullptr, *y_min = nullptr, *y_max = nullptr;
  int nx = 0, ny = 0;

  template <class R>
  void note_columns(const Tile& t, int j, const R* mass) const {
    if (x_min != nullptr && t.i0 == 0) {
      x_min[j] = static_cast<double>(mass[0]);
    }
    if (x_max != nullptr && t.i1 == nx) {
      x_max[j] = static_cast<double>(mass[nx]);
    }
  }
  template <class R>
  void note_rows(const Tile& t, int j, const R* mass) const {
    double* side = j == 0 ? y_min : (j == ny ? y_max : nullptr);
    if (side != nullptr) {
      for (int i = t.i0; i < t.i1; ++i) {
        side[i] = static_cast<double>(mass[i]);
      }
    }
  }
};

/// Rows of temporaries for one tile. A row of scratch holds the columns [i0 - pad, i1 + pad).
template <class R>
class Scratch {
 public:
  static constexpr int pad = 16;
  Scratch(int rows, int columns)
      : stride_((static_cast<std::size_t>(columns) + 2 * pad + 15) / 16 * 16),
        values_(stride_ * static_cast<std::size_t>(rows) + 16) {}
  /// Pointer p such that p[i] is column i of the tile that starts at i0.
  R* row(int index, int i0) { return values_.data() + stride_ * static_cast<std::size_t>(index) + pad - i0; }
  std::size_t bytes() const { return values_.size() * sizeof(R); }

 private:
  std::size_t stride_;
  std::vector<R> values_;
};

/// The bits of one cell's new state.
template <class R>
SANDSIM_HD int step_flags(R h_old, R hu_old, R hv_old, R h, R hu, R hv) {
  const R largest = std::numeric_limits<R>::max();
  const bool moves = (hu != R(0)) | (hv != R(0));
  const bool differs = (h != h_old) | (hu != hu_old) | (hv != hv_old);
  const bool sound = (h >= R(0)) & (h <= largest) & (physics::absolute(hu) + physics::absolute(hv) <= largest);
  return (moves ? moving : 0) | (differs ? changed : 0) | (sound ? 0 : broken);
}

/// A cell's material: the run's, or the maps'.
template <bool Uniform, class R>
SANDSIM_HD physics::Material<R> material_at(const physics::Material<R>& uniform, const R* mu, const R* alpha,
                                            const R* cap, std::ptrdiff_t i) {
  if constexpr (Uniform) {
    return uniform;
  } else {
    return {mu[i], alpha[i], cap[i]};
  }
}

}  // namespace sandsim::cpu
