// Along one axis, what the columns (or rows) of a raster weigh in each of the grid's.
#pragma once

#include <cstddef>
#include <vector>

#include "solver/scene.hpp"

namespace sandsim {

/// Of consecutive columns of a raster; empty where there are none.
struct AxisWeights {
  std::size_t first = 0;
  std::vector<double> weights;
};

/// How far a position among centres [in cells] may be off for the rounding of the coordinates [m].
double rounding_in_cells(double coordinate, double origin, double spacing);

/// For each of the grid's cells along the axis the lengths that the raster's columns cover of it, in cells. Edges that
/// lie on a face of the grid but for rounding lie on it; all are rounded to 2^-30 of a cell.
std::vector<AxisWeights> overlaps(double origin, double spacing, std::size_t count, const Grid& grid, std::size_t axis);

/// The lengths of the raster's columns, in cells, with edges rounded likewise.
std::vector<double> lengths(double origin, double spacing, std::size_t count, const Grid& grid, std::size_t axis);

/// The part of each of the raster's columns that the grid covers, in cells.
std::vector<double> covered_lengths(const std::vector<AxisWeights>& cells, std::size_t count);

/// The weights over their sum.
AxisWeights normalised(AxisWeights weights);

/// The sum of weight(column) weight(row) term(column, row), which keeps its bits when the raster is mirrored (pairs
/// from both ends) or transposed (the mean of both orders of summation).
template <typename Term>
double symmetric_sum(const AxisWeights& x, const AxisWeights& y, Term term) {
  const auto along = [](const AxisWeights& axis, auto inner) {
    const std::size_t count = axis.weights.size();
    const auto weighted = [&](std::size_t k) { return axis.weights[k] * inner(axis.first + k); };
    double sum = 0.0;
    for (std::size_t k = 0; k < count / 2; ++k) {
      sum += weighted(k) + weighted(count - 1 - k);
    }
    return count % 2 == 1 ? sum + weighted(count / 2) : sum;
  };
  const double rows_of_columns =
      along(y, [&](std::size_t row) { return along(x, [&](std::size_t column) { return term(column, row); }); });
  const double columns_of_rows =
      along(x, [&](std::size_t column) { return along(y, [&](std::size_t row) { return term(column, row); }); });
  return 0.5 * (rows_of_columns + columns_of_rows);
}

}  // namespace sandsim
