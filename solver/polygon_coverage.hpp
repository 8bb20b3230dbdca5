// How much of each cell a polygon covers.
#pragma once

#include <array>
#include <cstddef>
#include <functional>

#include "solver/polygons.hpp"
#include "solver/scene.hpp"

namespace sandsim {

/// Smallest and largest x and y. [m]
struct Bounds {
  std::array<double, 2> low{};
  std::array<double, 2> high{};
};
/// Of all features; the layer has one at least.
Bounds bounds_of(const PolygonLayer& layer);

/// The area of a feature, holes taken out, with corners rounded as below. [m^2]
double area_of(const PolygonFeature& feature, const Grid& grid);

/// Calls `action(cell, part)` for the cells that the feature covers, in their order, with the covered part of their
/// area: exact but for rounding, for any number of rings and holes. Corners are rounded to 2^-30 of a cell, parts to
/// 2^-40, so that edges along faces leave no slivers. The parts add up to the area of the feature within the grid.
/// Costs the edges' length in cells and the cells of the bounding box.
void for_each_covered_cell(const PolygonFeature& feature, const Grid& grid,
                           const std::function<void(std::size_t cell, double part)>& action);

}  // namespace sandsim
