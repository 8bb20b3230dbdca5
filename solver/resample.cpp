#include "solver/resample.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

#include "solver/axis_weights.hpp"
#include "solver/coverage.hpp"

namespace sandsim {
namespace {

constexpr double no_data = std::numeric_limits<double>::quiet_NaN();

/// Where a coordinate lies among the centres of one axis.
struct AxisPosition {
  bool inside = false;
  std::size_t lower = 0;  // the two centres; the same one if the point lies on it or in the outermost half cell
  std::size_t upper = 0;
  double from_middle = 0.0;  // [-] from the middle between them, -1/2 to 1/2; 0 if they are the same
};

AxisPosition locate(double coordinate, double origin, double spacing, std::size_t count) {
  const double tolerance = rounding_in_cells(coordinate, origin, spacing);
  const double last = static_cast<double>(count - 1);
  const double position = (coordinate - origin) / spacing;
  // The negation also turns away a position that is not a number.
  if (!(position >= -0.5 - tolerance && position <= last + 0.5 + tolerance)) {
    return {};
  }
  const double clamped = std::clamp(position, 0.0, last);
  const double nearest = std::round(clamped);
  if (std::abs(clamped - nearest) <= tolerance) {
    const auto centre = static_cast<std::size_t>(nearest);
    return {true, centre, centre, 0.0};
  }
  const double lower = std::floor(clamped);
  const auto index = static_cast<std::size_t>(lower);
  return {true, index, index + 1, (clamped - lower) - 0.5};
}

/// The four values about a point, [upper in y][upper in x].
using Corners = std::array<std::array<double, 2>, 2>;

/// The mean of the corners with data by their bilinear weights, if the nearest corner has data.
double interpolate_with_gaps(const Corners& corners, const AxisPosition& x, const AxisPosition& y) {
  constexpr double rounding = 1e-9;  // of a point on the edge between two cells
  bool nearest_has_data = false;
  double base = -std::numeric_limits<double>::infinity();
  std::array<double, 4> weights{};
  std::array<double, 4> values{};
  for (std::size_t row = 0; row < 2; ++row) {
    for (std::size_t column = 0; column < 2; ++column) {
      const double value = corners[row][column];
      if (std::isnan(value)) {
        continue;
      }
      const double along_x = column == 0 ? -x.from_middle : x.from_middle;
      const double along_y = row == 0 ? -y.from_middle : y.from_middle;
      nearest_has_data = nearest_has_data || (along_x >= -rounding && along_y >= -rounding);
      // Diagonal neighbours first: sums of pairs keep their bits when the raster is mirrored or transposed.
      const std::size_t k = row == column ? row : 2 + row;
      weights[k] = (0.5 + along_x) * (0.5 + along_y);
      values[k] = value;
      base = std::max(base, value);
    }
  }
  if (!nearest_has_data) {
    return no_data;
  }
  // Differences from one of the values: equal values give themselves.
  std::array<double, 4> excess{};
  for (std::size_t k = 0; k < 4; ++k) {
    excess[k] = weights[k] > 0.0 ? weights[k] * (values[k] - base) : 0.0;
  }
  const auto sum = [](const std::array<double, 4>& terms) { return (terms[0] + terms[1]) + (terms[2] + terms[3]); };
  return base + sum(excess) / sum(weights);
}

double interpolate(const Raster& raster, const AxisPosition& x, const AxisPosition& y) {
  if (!x.inside || !y.inside) {
    return no_data;
  }
  const double v00 = raster.at(x.lower, y.lower);
  if (x.lower == x.upper && y.lower == y.upper) {
    return v00;
  }
  const double v10 = raster.at(x.upper, y.lower);
  const double v01 = raster.at(x.lower, y.upper);
  const double v11 = raster.at(x.upper, y.upper);
  if (std::isnan(v00 + v11 + v10 + v01)) {
    return interpolate_with_gaps({{{v00, v10}, {v01, v11}}}, x, y);
  }
  // The mean and the differences change at most their sign when the raster is mirrored or transposed, and equal values
  // give themselves: neither is true of sums of weights times values.
  const double sum = (v00 + v11) + (v10 + v01);
  const double along_x = (v10 + v11) - (v00 + v01);
  const double along_y = (v01 + v11) - (v00 + v10);
  const double twist = (v00 + v11) - (v10 + v01);
  return 0.25 * sum +
         (0.5 * (x.from_middle * along_x + y.from_middle * along_y) + x.from_middle * y.from_middle * twist);
}

/// The bilinear weights of an axis whose spacing is not less than the grid's.
AxisWeights bilinear_weights(const AxisPosition& at) {
  if (!at.inside) {
    return {};
  }
  if (at.lower == at.upper) {
    return {at.lower, {1.0}};
  }
  return {at.lower, {0.5 - at.from_middle, 0.5 + at.from_middle}};
}

/// The mean of the values with data by the weights' products; NaN if these are less than half of all.
double mean(const Raster& raster, const AxisWeights& x, const AxisWeights& y) {
  double base = -std::numeric_limits<double>::infinity();
  for (std::size_t row = 0; row < y.weights.size(); ++row) {
    for (std::size_t column = 0; column < x.weights.size(); ++column) {
      base = std::fmax(base, raster.at(x.first + column, y.first + row));
    }
  }
  const double weight = symmetric_sum(
      x, y, [&](std::size_t column, std::size_t row) { return std::isnan(raster.at(column, row)) ? 0.0 : 1.0; });
  constexpr double half = 0.5 - 1e-9;  // but for rounding
  if (weight < half) {
    return no_data;
  }
  const double excess = symmetric_sum(x, y, [&](std::size_t column, std::size_t row) {
    const double value = raster.at(column, row);
    return std::isnan(value) ? 0.0 : value - base;
  });
  return base + excess / weight;
}

struct Axis {
  double origin;  // [m] of the raster's first centre
  double spacing;
  std::size_t count;
};

}  // namespace

double sample(const Raster& raster, double x, double y) {
  const AxisPosition column = locate(x, raster.origin_x, raster.spacing_x, raster.nx);
  const AxisPosition row = locate(y, raster.origin_y, raster.spacing_y, raster.ny);
  return interpolate(raster, column, row);
}

bool fits(const Raster& raster, const Grid& grid) {
  return raster.has_georeference ||
         (raster.nx == static_cast<std::size_t>(grid.cells[0]) && raster.ny == static_cast<std::size_t>(grid.cells[1]));
}

std::vector<double> resample(const Raster& raster, const Grid& grid) {
  if (!raster.has_georeference) {
    return raster.values;
  }
  const std::array<Axis, 2> axes{Axis{raster.origin_x, raster.spacing_x, raster.nx},
                                 Axis{raster.origin_y, raster.spacing_y, raster.ny}};
  std::array<std::vector<AxisPosition>, 2> positions;
  std::array<std::vector<AxisWeights>, 2> weights;
  std::array<bool, 2> is_finer{};
  for (std::size_t k = 0; k < 2; ++k) {
    const Axis& axis = axes[k];
    constexpr double rounding = 1e-9;  // spacings that are meant to be equal
    is_finer[k] = axis.spacing < grid.spacing * (1.0 - rounding);
    for (int i = 0; i < grid.cells[k]; ++i) {
      positions[k].push_back(locate(k == 0 ? grid.x(i) : grid.y(i), axis.origin, axis.spacing, axis.count));
    }
    if (is_finer[k]) {
      weights[k] = overlaps(axis.origin, axis.spacing, axis.count, grid, k);
    } else {
      std::transform(positions[k].begin(), positions[k].end(), std::back_inserter(weights[k]), bilinear_weights);
    }
  }
  std::vector<double> values;
  values.reserve(grid.cell_count());
  for (std::size_t j = 0; j < positions[1].size(); ++j) {
    for (std::size_t i = 0; i < positions[0].size(); ++i) {
      values.push_back(is_finer[0] || is_finer[1] ? mean(raster, weights[0][i], weights[1][j])
                                                  : interpolate(raster, positions[0][i], positions[1][j]));
    }
  }
  return values;
}

SpreadRaster spread(const Raster& raster, const Grid& grid) {
  SpreadRaster result;
  result.depth.reserve(grid.cell_count());
  const auto value = [&](std::size_t column, std::size_t row) {
    const double depth = raster.at(column, row);
    return std::isnan(depth) ? 0.0 : depth;
  };
  if (!raster.has_georeference) {
    for (std::size_t row = 0; row < raster.ny; ++row) {
      for (std::size_t column = 0; column < raster.nx; ++column) {
        result.depth.push_back(value(column, row));
      }
    }
    return result;
  }
  const std::vector<AxisWeights> columns = overlaps(raster.origin_x, raster.spacing_x, raster.nx, grid, 0);
  std::vector<AxisWeights> rows = overlaps(raster.origin_y, raster.spacing_y, raster.ny, grid, 1);
  if (grid.one_dimensional()) {
    rows[0] = normalised(rows[0]);
  }
  for (const AxisWeights& row : rows) {
    for (const AxisWeights& column : columns) {
      result.depth.push_back(symmetric_sum(column, row, value));
    }
  }
  const std::vector<double> inside_x = covered_lengths(columns, raster.nx);
  const std::vector<double> inside_y = covered_lengths(rows, raster.ny);
  const std::vector<double> whole_x = lengths(raster.origin_x, raster.spacing_x, raster.nx, grid, 0);
  // In a 1-D scene rows that do not cover the grid's do not count, unless none does.
  const bool counts_rows = !grid.one_dimensional() || rows[0].weights.empty();
  const std::vector<double> whole_y =
      counts_rows ? lengths(raster.origin_y, raster.spacing_y, raster.ny, grid, 1) : inside_y;
  for (std::size_t row = 0; row < raster.ny; ++row) {
    for (std::size_t column = 0; column < raster.nx; ++column) {
      result.outside += value(column, row) * (whole_x[column] * whole_y[row] - inside_x[column] * inside_y[row]);
    }
  }
  result.outside *= grid.spacing * grid.spacing;
  return result;
}

// ---- the nearest value ----------------------------------------------------------------------------------------------

NearestValue::NearestValue(const Raster& raster)
    : raster_(raster), below_(raster.values.size(), -1), above_(raster.values.size(), static_cast<int>(raster.ny)) {
  for (std::size_t column = 0; column < raster.nx; ++column) {
    int latest = -1;
    for (std::size_t row = 0; row < raster.ny; ++row) {
      latest = std::isnan(raster.at(column, row)) ? latest : static_cast<int>(row);
      below_[row * raster.nx + column] = latest;
    }
    latest = static_cast<int>(raster.ny);
    for (std::size_t row = raster.ny; row-- > 0;) {
      latest = std::isnan(raster.at(column, row)) ? latest : static_cast<int>(row);
      above_[row * raster.nx + column] = latest;
    }
  }
}

double NearestValue::at(double x, double y) const {
  const double position_x = in_cells(x - raster_.origin_x, raster_.spacing_x);
  const double position_y = in_cells(y - raster_.origin_y, raster_.spacing_y);
  const auto last_column = static_cast<int>(raster_.nx) - 1;
  const auto row =
      static_cast<std::size_t>(std::clamp(std::floor(position_y), 0.0, static_cast<double>(raster_.ny - 1)));
  const auto start = static_cast<int>(std::clamp(std::round(position_x), 0.0, static_cast<double>(last_column)));
  double smallest = std::numeric_limits<double>::infinity();
  int nearest_column = -1;
  int nearest_row = -1;
  const auto along_x = [&](int column) { return (column - position_x) * raster_.spacing_x; };
  const auto try_cell = [&](int column, int candidate) {
    if (candidate < 0 || candidate >= static_cast<int>(raster_.ny)) {
      return;
    }
    const double along_y = (candidate - position_y) * raster_.spacing_y;
    const double square = along_x(column) * along_x(column) + along_y * along_y;
    const bool is_first = candidate < nearest_row || (candidate == nearest_row && column < nearest_column);
    if (square < smallest || (square == smallest && is_first)) {
      smallest = square, nearest_column = column, nearest_row = candidate;
    }
  };
  // Whether columns further out may be as near.
  const auto try_column = [&](int column) {
    if (column < 0 || column > last_column || along_x(column) * along_x(column) > smallest) {
      return false;
    }
    try_cell(column, below_[row * raster_.nx + static_cast<std::size_t>(column)]);
    try_cell(column, above_[std::min(row + 1, raster_.ny - 1) * raster_.nx + static_cast<std::size_t>(column)]);
    return true;
  };
  bool west = try_column(start);
  bool east = west;
  for (int step = 1; west || east; ++step) {
    west = try_column(start - step);
    east = try_column(start + step);
  }
  return raster_.at(static_cast<std::size_t>(nearest_column), static_cast<std::size_t>(nearest_row));
}

}  // namespace sandsim
