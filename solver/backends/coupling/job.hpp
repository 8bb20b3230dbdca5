// What the coupling of one object with the sand works on: the patch of cells under its box, as plain pointers.
#pragma once

#include <cstddef>
#include <cstdint>

#include "solver/backends/coupling/contact.hpp"
#include "solver/backends/cover.hpp"
#include "solver/backends/tiles/tile_fields.hpp"
#include "solver/scene_objects.hpp"

namespace sandsim::coupling {

/// Columns [i0, i1) of rows [j0, j1).
struct Patch {
  int i0 = 0, i1 = 0, j0 = 0, j1 = 0;

  SANDSIM_HD bool empty() const { return i0 >= i1 || j0 >= j1; }
  SANDSIM_HD int width() const { return i1 - i0; }
  SANDSIM_HD int cells() const { return (i1 - i0) * (j1 - j0); }
  SANDSIM_HD bool holds(int i, int j) const { return i >= i0 && i < i1 && j >= j0 && j < j1; }
};

/// A column takes no sand if the gap under the object is less than this fraction of the spacing.
inline constexpr double least_gap = 0.1;

/// Numbers a cell of the patch that live while an object is coupled.
inline constexpr int scratch_rows = 12;

/// Sums over a patch, in the order of sum_in_lanes().
struct CouplingSums {
  double overlap = 0.0;                       // [m]
  double displaced = 0.0;                     // [m]
  double momentum_x = 0.0, momentum_y = 0.0;  // [m^2/s] given to the sand
  double work = 0.0;                          // [m^3/s^2] momentum times the object's velocity
  double deepest = 0.0;                       // [m] of the object below the highest sand beside it
  double changed = 0.0;                       // cells

  SANDSIM_HD CouplingSums& operator+=(const CouplingSums& other) {
    overlap += other.overlap, displaced += other.displaced;
    momentum_x += other.momentum_x, momentum_y += other.momentum_y, work += other.work;
    deepest = physics::maximum(deepest, other.deepest);
    changed += other.changed;
    return *this;
  }
};

/// An object at the end of a step.
struct Body {
  std::size_t object = 0;  // of the configuration
  objects::ShapeView shape;
  objects::RigidState state;
  Patch patch;                  // of its box; empty if the object has left
  bool still = false;           // it did not move in the step
  bool solid = false;           // no sand stays inside, whatever rests
  double lowest = 0.0;          // [m] nothing of the object is lower
  double sample_spacing = 0.0;  // [m] along a column of sand, where the shape is sampled
};

template <class R>
struct Job {
  tiles::StateView<R> state;
  FieldView<R> bed;  // as the flow sees it; not read where `flat`
  Cover<R> cover;    // none for `drag`
  Boundaries sides;
  bool flat = false;
  bool one_d = false;
  int nx = 0, ny = 0;
  double x0 = 0.0, y0 = 0.0, dx = 0.0;  // [m] corner of the grid, spacing
  Patch patch;                          // around the object at the two ends of the step
  Body body;
  const Body* others = nullptr;  // of the same kind of coupling, that reach into the patch
  int other_count = 0;
  double most_speed = 0.0;  // [m/s] of the sand that covering objects push
  VerticalTransfer vertical = VerticalTransfer::none;
  double* scratch = nullptr;     // scratch_rows numbers a cell, row by row
  int* levels = nullptr;         // one a cell
  CouplingSums* sums = nullptr;  // the result

  SANDSIM_HD double* row(int kind) const { return scratch + static_cast<std::int64_t>(kind) * patch.cells(); }
  SANDSIM_HD int i(int cell) const { return patch.i0 + cell % patch.width(); }
  SANDSIM_HD int j(int cell) const { return patch.j0 + cell / patch.width(); }
  SANDSIM_HD double bed_at(int cell) const { return flat ? 0.0 : static_cast<double>(bed.row(j(cell))[i(cell)]); }
  /// Whether an object whose lowest point is at `lowest` may touch sand up to this height, or leave it too little of a
  /// gap.
  SANDSIM_HD bool is_near(double lowest, double surface) const { return lowest < surface + least_gap * dx; }
  /// Of a body with the sand of a column that stands on `ground` and reaches up to `surface`.
  SANDSIM_HD Contact contact(const Body& other, int cell, double ground, double surface) const {
    return find_contact(other.shape, other.state, x0 + (i(cell) + 0.5) * dx, y0 + (j(cell) + 0.5) * dx, ground, surface,
                        other.sample_spacing);
  }
  /// The neighbour of a cell: west, east, south, north; -1 outside the patch.
  SANDSIM_HD int neighbour(int cell, int side) const {
    const int column = cell % patch.width();
    switch (side) {
      case 0:
        return column > 0 ? cell - 1 : -1;
      case 1:
        return column + 1 < patch.width() ? cell + 1 : -1;
      case 2:
        return cell - patch.width() >= 0 ? cell - patch.width() : -1;
      default:
        return cell + patch.width() < patch.cells() ? cell + patch.width() : -1;
    }
  }
};

/// phase(cell) for every cell of the patch, then a wait.
template <class Block, class R, class Phase>
SANDSIM_HD void each_cell(Block& block, const Job<R>& job, const Phase& phase) {
  block.each([&](int x, int strip) {
    const int threads = block.width() * block.strips();
    for (int cell = strip * block.width() + x; cell < job.patch.cells(); cell += threads) {
      phase(cell);
    }
  });
}

}  // namespace sandsim::coupling
