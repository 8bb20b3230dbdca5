// The grid that a raster asks for.
#pragma once

#include <array>
#include <optional>
#include <variant>

#include "solver/checks.hpp"
#include "solver/raster.hpp"
#include "solver/scene.hpp"

namespace sandsim {

/// What a scene says of a grid that is taken from a raster. Lengths in m.
struct GridLike {
  std::optional<RasterFile> like;
  std::optional<std::array<double, 4>> extent;  // x_min, y_min, x_max, y_max: the part of the raster that is taken
  double margin = 0.0;                          // left out along each side
};

/// The raster's cells, or those of its part, with its CRS; or why there is no such grid. Without `spacing` (0) their
/// edges are those of the raster's cells. With a spacing the grid begins in the lower left corner and holds the whole
/// cells that fit.
std::variant<Grid, Issue> grid_of(const GridLike& from, double spacing);

}  // namespace sandsim
