// A signed distance known at the points of a regular grid.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "solver/objects/bounds.hpp"
#include "solver/objects/primitive.hpp"

namespace sandsim::objects {

/// Points at origin + (i, j, k) spacing, i fastest; at least two along each axis.
struct DistanceGrid {
  std::array<int, 3> points{0, 0, 0};
  Vec3 origin;                // [m] point (0, 0, 0)
  double spacing = 0.0;       // [m]
  std::vector<float> values;  // [m] negative inside
};

/// The same in other units: all lengths times `factor`.
DistanceGrid scaled(const DistanceGrid& grid, double factor);

/// The box around the part that is inside: all cells with a negative corner. Empty if there is none.
Bounds inside_bounds(const DistanceGrid& grid);

/// Samples on the sides of the grid's box, by what they are.
struct Rim {
  std::size_t samples = 0;
  std::size_t inside = 0;   // negative
  std::size_t outside = 0;  // positive
};
Rim rim_of(const DistanceGrid& grid);

/// View of a grid that kernels take by value.
struct DistanceGridView {
  int nx = 0;
  int ny = 0;
  int nz = 0;
  Vec3 origin;
  double spacing = 1.0;
  const float* values = nullptr;

  SANDSIM_HD double at(int i, int j, int k) const {
    return static_cast<double>(values[(static_cast<std::size_t>(k) * ny + j) * nx + i]);
  }
};

inline DistanceGridView view(const DistanceGrid& g) {
  return {g.points[0], g.points[1], g.points[2], g.origin, g.spacing, g.values.data()};
}

namespace detail {

/// The cell of a coordinate in spacings, kept on the grid, and where in it the coordinate lies (0 to 1).
SANDSIM_HD int grid_cell(double coordinate, int points, double& part) {
  const double last = points - 1;
  const double kept = coordinate > 0.0 ? (coordinate < last ? coordinate : last) : 0.0;
  int cell = static_cast<int>(kept);
  if (cell > points - 2) cell = points - 2;
  part = kept - cell;
  return cell;
}

SANDSIM_HD double mix(double a, double b, double part) {
  return a + part * (b - a);
}

}  // namespace detail

/// Trilinear interpolation; beyond the grid the value at its nearest point plus the distance to that point.
SANDSIM_HD double distance(const DistanceGridView& g, const Vec3& p) {
  const Vec3 q = (1.0 / g.spacing) * (p - g.origin);
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  const int i = detail::grid_cell(q.x, g.nx, x);
  const int j = detail::grid_cell(q.y, g.ny, y);
  const int k = detail::grid_cell(q.z, g.nz, z);
  const double low = detail::mix(detail::mix(g.at(i, j, k), g.at(i + 1, j, k), x),
                                 detail::mix(g.at(i, j + 1, k), g.at(i + 1, j + 1, k), x), y);
  const double high = detail::mix(detail::mix(g.at(i, j, k + 1), g.at(i + 1, j, k + 1), x),
                                  detail::mix(g.at(i, j + 1, k + 1), g.at(i + 1, j + 1, k + 1), x), y);
  const Vec3 beyond = q - Vec3{i + x, j + y, k + z};
  const double squared = dot(beyond, beyond);
  return detail::mix(low, high, z) + (squared > 0.0 ? g.spacing * std::sqrt(squared) : 0.0);
}

}  // namespace sandsim::objects
