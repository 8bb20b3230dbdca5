#include "solver/axis_weights.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "solver/coverage.hpp"

namespace sandsim {
namespace {

/// The count + 1 edges of the raster's columns, in cells of the grid.
std::vector<double> edges(double origin, double spacing, std::size_t count, const Grid& grid, std::size_t axis) {
  std::vector<double> result;
  result.reserve(count + 1);
  const double corner = grid.origin[axis];
  for (std::size_t k = 0; k <= count; ++k) {
    const double edge = origin + (static_cast<double>(k) - 0.5) * spacing;
    const double position = in_cells(edge - corner, grid.spacing);
    const double face = std::round(position);
    result.push_back(std::abs(position - face) <= rounding_in_cells(edge, corner, grid.spacing) ? face : position);
  }
  return result;
}

}  // namespace

double rounding_in_cells(double coordinate, double origin, double spacing) {
  constexpr double rounding = 4.0 * std::numeric_limits<double>::epsilon();
  return 1e-9 + rounding * (std::abs(coordinate) + std::abs(origin)) / spacing;
}

std::vector<AxisWeights> overlaps(double origin, double spacing, std::size_t count, const Grid& grid,
                                  std::size_t axis) {
  const std::vector<double> edge = edges(origin, spacing, count, grid, axis);
  std::vector<AxisWeights> cells(static_cast<std::size_t>(grid.cells[axis]));
  for (std::size_t k = 0; k < count; ++k) {
    const double from = std::max(edge[k], 0.0);
    const double to = std::min(edge[k + 1], static_cast<double>(cells.size()));
    for (double cell = std::floor(from); cell < to; cell += 1.0) {
      AxisWeights& weights = cells[static_cast<std::size_t>(cell)];
      weights.first = weights.weights.empty() ? k : weights.first;
      weights.weights.push_back(covered_length(edge[k], edge[k + 1], static_cast<int>(cell)));
    }
  }
  return cells;
}

std::vector<double> lengths(double origin, double spacing, std::size_t count, const Grid& grid, std::size_t axis) {
  const std::vector<double> edge = edges(origin, spacing, count, grid, axis);
  std::vector<double> result;
  for (std::size_t k = 0; k < count; ++k) {
    result.push_back(edge[k + 1] - edge[k]);
  }
  return result;
}

std::vector<double> covered_lengths(const std::vector<AxisWeights>& cells, std::size_t count) {
  std::vector<double> result(count, 0.0);
  for (const AxisWeights& cell : cells) {
    for (std::size_t k = 0; k < cell.weights.size(); ++k) {
      result[cell.first + k] += cell.weights[k];
    }
  }
  return result;
}

AxisWeights normalised(AxisWeights weights) {
  const double sum = std::accumulate(weights.weights.begin(), weights.weights.end(), 0.0);
  for (double& weight : weights.weights) {
    weight /= sum;
  }
  return weights;
}

}  // namespace sandsim
