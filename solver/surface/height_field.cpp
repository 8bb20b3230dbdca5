#include "solver/surface/height_field.hpp"

#include <algorithm>

namespace sandsim::surface {

namespace {

std::vector<double> node_coordinates(double origin, int cells, double spacing) {
  std::vector<double> nodes{origin};
  for (int k = 0; k < cells; ++k) nodes.push_back(origin + (k + 0.5) * spacing);
  nodes.push_back(origin + cells * spacing);
  return nodes;
}

/// The nodes on the sides take the value of the nearest centre.
std::vector<double> spread_to_sides(std::span<const double> cells, int nx, int ny) {
  std::vector<double> nodes;
  nodes.reserve(static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny));
  for (int j = 0; j < ny; ++j) {
    const std::size_t row = static_cast<std::size_t>(std::clamp(j - 1, 0, ny - 3)) * static_cast<std::size_t>(nx - 2);
    nodes.push_back(cells[row]);
    nodes.insert(nodes.end(), cells.begin() + row, cells.begin() + row + (nx - 2));
    nodes.push_back(cells[row + (nx - 3)]);
  }
  return nodes;
}

/// Gives the nodes on the sides what a line through the two nearest centres has there, half a spacing on.
void extend_linearly(std::vector<double>& values, int nx, int ny) {
  const auto next = [&](double first, double second) { return first + 0.5 * (first - second); };
  const auto at = [&](int i, int j) -> double& { return values[static_cast<std::size_t>(j) * nx + i]; };
  for (int j = 0; nx > 3 && j < ny; ++j) {
    at(0, j) = next(at(1, j), at(2, j));
    at(nx - 1, j) = next(at(nx - 2, j), at(nx - 3, j));
  }
  for (int i = 0; ny > 3 && i < nx; ++i) {
    at(i, 0) = next(at(i, 1), at(i, 2));
    at(i, ny - 1) = next(at(i, ny - 2), at(i, ny - 3));
  }
}

}  // namespace

std::array<double, 2> HeightField::gradient(int i, int j) const {
  const auto along = [this](int index, int nodes, std::size_t here, std::size_t stride) {
    const int centre = std::clamp(index, 1, nodes - 2);
    const std::size_t start = here + static_cast<std::size_t>(centre) * stride;
    const int low = centre > 1 ? 1 : 0;
    const int high = centre < nodes - 2 ? 1 : 0;
    if (low + high == 0) return 0.0;  // one cell
    return (elevation[start + high * stride] - elevation[start - low * stride]) / ((low + high) * spacing);
  };
  // Nodes on a side slope as the nearest centre does.
  const int row = std::clamp(j, 1, ny - 2);
  const int column = std::clamp(i, 1, nx - 2);
  return {along(i, nx, at(0, row), 1), along(j, ny, at(column, 0), static_cast<std::size_t>(nx))};
}

HeightField height_field(const Grid& grid, std::span<const double> bed, std::span<const double> depth,
                         std::span<const double> elevation) {
  HeightField field;
  field.nx = grid.cells[0] + 2;
  field.ny = grid.cells[1] + 2;
  field.spacing = grid.spacing;
  field.x = node_coordinates(grid.origin[0], grid.cells[0], grid.spacing);
  field.y = node_coordinates(grid.origin[1], grid.cells[1], grid.spacing);
  field.bed = spread_to_sides(bed, field.nx, field.ny);
  field.depth = spread_to_sides(depth, field.nx, field.ny);
  for (double& value : field.depth) value = std::max(value, 0.0);
  if (!elevation.empty()) {
    field.elevation = spread_to_sides(elevation, field.nx, field.ny);
    for (std::size_t k = 0; k < field.elevation.size(); ++k) field.elevation[k] -= field.bed[k];  // over the bed
  } else {
    field.elevation = field.depth;
  }
  extend_linearly(field.bed, field.nx, field.ny);
  for (std::size_t k = 0; k < field.elevation.size(); ++k) field.elevation[k] += field.bed[k];
  return field;
}

}  // namespace sandsim::surface
