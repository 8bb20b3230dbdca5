#include "solver/resample.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sandsim {
namespace {

/// Where a coordinate lies among the centres of one axis.
struct AxisPosition {
  bool inside = false;
  std::size_t lower = 0;  // the two centres; the same one if the point lies on it or in the outermost half cell
  std::size_t upper = 0;
  double from_middle = 0.0;  // [-] from the middle between them, -1/2 to 1/2; 0 if they are the same
};

AxisPosition locate(double coordinate, double origin, double spacing, std::size_t count) {
  constexpr double rounding = 4.0 * std::numeric_limits<double>::epsilon();
  const double tolerance = 1e-9 + rounding * (std::abs(coordinate) + std::abs(origin)) / spacing;
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

double interpolate(const Raster& raster, const AxisPosition& x, const AxisPosition& y) {
  if (!x.inside || !y.inside) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const double v00 = raster.at(x.lower, y.lower);
  if (x.lower == x.upper && y.lower == y.upper) {
    return v00;
  }
  const double v10 = raster.at(x.upper, y.lower);
  const double v01 = raster.at(x.lower, y.upper);
  const double v11 = raster.at(x.upper, y.upper);
  // The mean and the differences change at most their sign when the raster is mirrored or transposed, and equal values
  // give themselves: neither is true of sums of weights times values.
  const double sum = (v00 + v11) + (v10 + v01);
  const double along_x = (v10 + v11) - (v00 + v01);
  const double along_y = (v01 + v11) - (v00 + v10);
  const double twist = (v00 + v11) - (v10 + v01);
  return 0.25 * sum +
         (0.5 * (x.from_middle * along_x + y.from_middle * along_y) + x.from_middle * y.from_middle * twist);
}

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
  std::vector<AxisPosition> columns;
  for (int i = 0; i < grid.cells[0]; ++i) {
    columns.push_back(locate(grid.x(i), raster.origin_x, raster.spacing_x, raster.nx));
  }
  std::vector<double> values;
  values.reserve(grid.cell_count());
  for (int j = 0; j < grid.cells[1]; ++j) {
    const AxisPosition row = locate(grid.y(j), raster.origin_y, raster.spacing_y, raster.ny);
    for (const AxisPosition& column : columns) {
      values.push_back(interpolate(raster, column, row));
    }
  }
  return values;
}

}  // namespace sandsim
