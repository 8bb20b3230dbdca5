// What the row kernels of both schemes share: views of the fields, scratch rows, tiles.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "solver/backends/cpu/pack.hpp"
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
/// summed after the step, in the order of rows and columns. Sand leaves through an open side and none enters: a flux
/// inwards is taken out.
struct SideFlow {
  double *x_min = nullptr, *x_max = nullptr, *y_min = nullptr, *y_max = nullptr;
  int nx = 0, ny = 0;

  /// The faces along row j of a tile.
  template <class FluxRow>
  void pass_columns(const Tile& t, int j, const FluxRow& faces) const {
    if (x_min != nullptr && t.i0 == 0) {
      x_min[j] = -pass(faces, 0, false);
    }
    if (x_max != nullptr && t.i1 == nx) {
      x_max[j] = pass(faces, nx, true);
    }
  }
  /// The faces between rows j - 1 and j of a tile.
  template <class FluxRow>
  void pass_rows(const Tile& t, int j, const FluxRow& faces) const {
    const bool high = j == ny;
    double* side = j == 0 ? y_min : (high ? y_max : nullptr);
    for (int i = t.i0; side != nullptr && i < t.i1; ++i) {
      side[i] = high ? pass(faces, i, true) : -pass(faces, i, false);
    }
  }

 private:
  /// Takes out a flux inwards; returns the mass flux that is left.
  template <class FluxRow>
  static double pass(const FluxRow& faces, int i, bool high) {
    if (high ? faces.mass[i] < 0 : faces.mass[i] > 0) {
      faces.mass[i] = faces.normal[i] = faces.transverse[i] = 0;
    }
    return static_cast<double>(faces.mass[i]);
  }
};

/// Rows of temporaries for one tile. A row of scratch holds the columns [i0 - pad, i1 + pad): the halo and what a pack
/// may reach past the end.
template <class R>
class Scratch {
 public:
  static constexpr int pad = 32;
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

/// Collects what happened to the cells of a row, a pack at a time.
template <class R>
struct StepWatch {
  using V = Pack<R>;
  using M = typename V::mask_type;
  M moves = M(false), differs = M(false), unsound = M(false);

  SANDSIM_HD void see(const M& inside, const V& h_old, const V& hu_old, const V& hv_old, const V& h, const V& hu,
                      const V& hv) {
    const V largest = std::numeric_limits<R>::max();
    moves |= inside & ((hu != V(0)) | (hv != V(0)));
    differs |= inside & ((h != h_old) | (hu != hu_old) | (hv != hv_old));
    const M sound = (h >= V(0)) & (h <= largest) & (physics::absolute(hu) + physics::absolute(hv) <= largest);
    unsound |= inside & !sound;
  }
  int flags() const {
    return (any_of(moves) ? moving : 0) | (any_of(differs) ? changed : 0) | (any_of(unsound) ? broken : 0);
  }
};

/// Materials of a pack of cells: the run's, or the maps'.
template <bool Uniform, class R>
SANDSIM_HD physics::Material<Pack<R>> material_at(const physics::Material<Pack<R>>& uniform, const R* mu,
                                                  const R* alpha, const R* cap, std::ptrdiff_t i) {
  if constexpr (Uniform) {
    return uniform;
  } else {
    return {load(mu, i), load(alpha, i), load(cap, i)};
  }
}

}  // namespace sandsim::cpu
