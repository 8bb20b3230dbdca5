#include "solver/coverage.hpp"

#include <algorithm>
#include <cmath>

namespace sandsim {

double in_cells(double length, double spacing) {
  constexpr double resolution = 1073741824.0;  // 2^30
  return std::round(length / spacing * resolution) / resolution;
}

double covered_length(double from, double to, int index) {
  const double lower = index;
  return std::max(0.0, std::min(to, lower + 1.0) - std::max(from, lower));
}

double covered_by_disc(std::array<double, 2> offset, double radius) {
  const double x = std::abs(offset[0]);
  const double y = std::abs(offset[1]);
  const double square = radius * radius;
  const double nearest_x = std::max(0.0, x - 0.5);
  const double nearest_y = std::max(0.0, y - 0.5);
  if (nearest_x * nearest_x + nearest_y * nearest_y > square) {
    return 0.0;
  }
  if ((x + 0.5) * (x + 0.5) + (y + 0.5) * (y + 0.5) <= square) {
    return 1.0;
  }
  constexpr int points = 8;
  int inside = 0;
  for (int row = 0; row < points; ++row) {
    const double point_y = y + ((row + 0.5) / points - 0.5);
    for (int column = 0; column < points; ++column) {
      const double point_x = x + ((column + 0.5) / points - 0.5);
      inside += point_x * point_x + point_y * point_y <= square ? 1 : 0;
    }
  }
  return static_cast<double>(inside) / (points * points);
}

}  // namespace sandsim
