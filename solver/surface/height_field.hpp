// A height field at the nodes of a mesh: cell centres, and points on the domain's sides.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "solver/scene.hpp"

namespace sandsim::surface {

/// Values at (cells + 2) nodes along each axis: the centres of the cells, and beyond the first and the last of them the
/// domain's sides, half a cell away. Towards the sides the bed goes on as it was and the height over it is that of the
/// nearest centre. The integral of the depth, linear between the nodes, is then the sum over the cells.
struct HeightField {
  int nx = 0;                     // nodes along x
  int ny = 0;                     // likewise along y
  double spacing = 0.0;           // [m] of the centres
  std::vector<double> x;          // [m] nx of them
  std::vector<double> y;          // [m] ny of them
  std::vector<double> bed;        // [m] j * nx + i
  std::vector<double> depth;      // [m] likewise, at least 0
  std::vector<double> elevation;  // [m] of the surface

  std::size_t at(int i, int j) const { return static_cast<std::size_t>(j) * static_cast<std::size_t>(nx) + i; }
  /// (dz/dx, dz/dy) at a node: central differences between centres, one-sided ones beside the domain's sides. [-]
  std::array<double, 2> gradient(int i, int j) const;
};

/// From `bed` and `depth` of the cells [m], x fastest, all finite. `elevation` of the surface is bed + depth where it
/// is empty. Depths below 0 count as 0.
HeightField height_field(const Grid& grid, std::span<const double> bed, std::span<const double> depth,
                         std::span<const double> elevation = {});

}  // namespace sandsim::surface
