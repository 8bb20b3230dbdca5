#include "solver/objects/distance_grid.hpp"

namespace sandsim::objects {

DistanceGrid scaled(const DistanceGrid& grid, double factor) {
  DistanceGrid result = grid;
  result.origin = factor * grid.origin;
  result.spacing = factor * grid.spacing;
  for (float& value : result.values) value = static_cast<float>(factor * static_cast<double>(value));
  return result;
}

Rim rim_of(const DistanceGrid& grid) {
  Rim rim;
  const DistanceGridView g = view(grid);
  for (int k = 0; k < g.nz; ++k) {
    for (int j = 0; j < g.ny; ++j) {
      const bool is_whole_row = k == 0 || k == g.nz - 1 || j == 0 || j == g.ny - 1;
      for (int i = 0; i < g.nx; i += is_whole_row ? 1 : g.nx - 1) {
        ++rim.samples;
        rim.inside += g.at(i, j, k) < 0.0 ? 1 : 0;
        rim.outside += g.at(i, j, k) > 0.0 ? 1 : 0;
      }
    }
  }
  return rim;
}

Bounds inside_bounds(const DistanceGrid& grid) {
  Bounds inside;
  const DistanceGridView g = view(grid);
  for (int k = 0; k < g.nz; ++k) {
    for (int j = 0; j < g.ny; ++j) {
      for (int i = 0; i < g.nx; ++i) {
        if (!(g.at(i, j, k) < 0.0)) continue;
        const Vec3 p = g.origin + g.spacing * Vec3{1.0 * i, 1.0 * j, 1.0 * k};
        const Vec3 cell{g.spacing, g.spacing, g.spacing};
        inside.include(p - cell);
        inside.include(p + cell);
      }
    }
  }
  if (inside.empty()) return inside;
  // Nothing is inside beyond the grid's own box.
  const Vec3 size = g.spacing * Vec3{g.nx - 1.0, g.ny - 1.0, g.nz - 1.0};
  return intersect(inside, {g.origin, g.origin + size});
}

}  // namespace sandsim::objects
