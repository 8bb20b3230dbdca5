// The grid that a raster asks for.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>

#include "solver/raster.hpp"
#include "solver/scene.hpp"

namespace sandsim {

/// What a scene says of a grid that is taken from a raster. Lengths in m.
struct GridLike {
  std::optional<RasterFile> like;
  std::optional<std::array<double, 4>> extent;  // x_min, y_min, x_max, y_max: the part of the raster that is taken
  double margin = 0.0;                          // left out along each side
};

/// Why there is no such grid: the key of the scene's grid that is to blame, the problem and why.
struct GridProblem {
  std::string key, problem, why, suggestion;
};

/// The raster's cells, or those of its part, with its CRS; without `spacing` (0) their edges are those of the raster's
/// cells. With a spacing the grid begins in the lower left corner and holds the whole cells that fit.
std::variant<Grid, GridProblem> grid_of(const GridLike& from, double spacing);

}  // namespace sandsim
