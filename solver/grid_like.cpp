#include "solver/grid_like.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/grid_problems.hpp"

namespace sandsim {
namespace {

/// The four sides of the raster's cells, as in GridLike::extent.
std::array<double, 4> sides(const Raster& raster) {
  const double x = raster.origin_x - 0.5 * raster.spacing_x;
  const double y = raster.origin_y - 0.5 * raster.spacing_y;
  return {x, y, x + static_cast<double>(raster.nx) * raster.spacing_x,
          y + static_cast<double>(raster.ny) * raster.spacing_y};
}

std::string text(const std::array<double, 4>& sides) {
  return "x from " + number_text(sides[0]) + " m to " + number_text(sides[2]) + " m and y from " +
         number_text(sides[1]) + " m to " + number_text(sides[3]) + " m";
}

}  // namespace

std::variant<Grid, Issue> grid_of(const GridLike& from, double spacing) {
  const Raster& raster = *from.like->data;
  if (!raster.has_georeference) {
    return Issue{"grid.like", "the file carries no position", "a grid needs an origin and a spacing",
                 "Give grid.cells, spacing and origin instead."};
  }
  constexpr double rounding = 1e-6;  // of a cell: headers are written with six digits or more
  const bool square = std::abs(raster.spacing_x - raster.spacing_y) <= rounding * raster.spacing_x;
  if (spacing == 0.0 && !square) {
    return Issue{"grid.like", "the raster's cells are no squares",
                 number_text(raster.spacing_x) + " m x " + number_text(raster.spacing_y) + " m",
                 "Add \"spacing: " + number_text(std::min(raster.spacing_x, raster.spacing_y)) + " m\"."};
  }
  const bool keeps_cells = spacing == 0.0;
  const std::array<double, 4> whole = sides(raster);
  std::array<double, 4> part = from.extent.value_or(whole);
  const std::string part_key = from.extent ? "grid.extent" : "grid.margin";
  for (std::size_t k = 0; k < 2; ++k) {
    part[k] += from.margin;
    part[k + 2] -= from.margin;
  }
  const double side = keeps_cells ? raster.spacing_x : spacing;
  Grid grid;
  grid.spacing = side;
  for (std::size_t k = 0; k < 2; ++k) {
    const double slack = rounding * side;
    if (part[k] < whole[k] - slack || part[k + 2] > whole[k + 2] + slack) {
      return Issue{part_key, "reaches beyond the raster", "the raster spans " + text(whole), ""};
    }
    const double length = (part[k + 2] - part[k]) / side;
    const double before = keeps_cells ? std::round((part[k] - whole[k]) / side) : 0.0;
    const double cells =
        keeps_cells ? std::round((part[k + 2] - whole[k]) / side) - before : std::floor(length + rounding);
    if (!(cells >= 1.0)) {
      return Issue{from.extent || from.margin > 0.0 ? part_key : "grid.spacing", "no cell is left",
                   number_text(std::max(0.0, part[k + 2] - part[k])) + " m along " + (k == 0 ? "x" : "y") +
                       ", cells of " + number_text(side) + " m",
                   ""};
    }
    if (cells > static_cast<double>(std::numeric_limits<int>::max())) {
      return Issue{"grid.spacing", "too many cells", "", "Use a larger spacing."};
    }
    grid.cells[k] = static_cast<int>(cells);
    grid.origin[k] = keeps_cells ? whole[k] + before * side : part[k];
  }
  grid.crs = raster.crs;
  return grid;
}

}  // namespace sandsim
