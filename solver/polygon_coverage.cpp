#include "solver/polygon_coverage.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "solver/coverage.hpp"

namespace sandsim {
namespace {

using Point = std::array<double, 2>;

Point corner_in_cells(const Point& corner, const Grid& grid) {
  return {in_cells(corner[0] - grid.origin[0], grid.spacing), in_cells(corner[1] - grid.origin[1], grid.spacing)};
}

/// Calls `action(from, to)` for every edge, in cells of the grid.
template <typename Action>
void for_each_edge(const PolygonFeature& feature, const Grid& grid, Action action) {
  for (const Ring& ring : feature.rings) {
    Point from = corner_in_cells(ring.back(), grid);
    for (const Point& corner : ring) {
      const Point to = corner_in_cells(corner, grid);
      action(from, to);
      from = to;
    }
  }
}

/// A rectangle of cells; parts of their area are gathered as the differences between each cell and the one before it in
/// the row. An edge that falls by dy covers dy of all cells to its right, for outer rings are counter-clockwise.
class Window {
 public:
  Window(int first_column, int first_row, int columns, int rows)
      : first_column_(first_column), first_row_(first_row), columns_(columns), rows_(rows) {
    differences_.resize((static_cast<std::size_t>(columns) + 1) * static_cast<std::size_t>(rows));
  }

  void add_edge(Point from, Point to) {
    from[0] -= first_column_, to[0] -= first_column_;
    from[1] -= first_row_, to[1] -= first_row_;
    if (from[1] == to[1]) {
      return;
    }
    const double rises = from[1] < to[1] ? 1.0 : -1.0;
    const Point& low = from[1] < to[1] ? from : to;
    const Point& high = from[1] < to[1] ? to : from;
    const double run = (high[0] - low[0]) / (high[1] - low[1]);
    const auto x_at = [&](double y) { return y == high[1] ? high[0] : low[0] + (y - low[1]) * run; };
    const double top = std::min(high[1], static_cast<double>(rows_));
    for (double y = std::max(low[1], 0.0); y < top;) {
      const double row = std::floor(y);
      const double next = std::min(row + 1.0, top);
      add_piece(static_cast<std::size_t>(row), x_at(y), x_at(next), -rises * (next - y));
      y = next;
    }
  }

  /// Parts of the cells, row by row.
  template <typename Action>
  void finish(Action action) const {
    constexpr double resolution = 1099511627776.0;  // 2^40
    const double* difference = differences_.data();
    for (int j = 0; j < rows_; ++j, difference += columns_ + 1) {
      double part = 0.0;
      for (int i = 0; i < columns_; ++i) {
        part += difference[i];
        action(first_column_ + i, first_row_ + j, std::round(part * resolution) / resolution);
      }
    }
  }

 private:
  /// A piece of an edge within one row, that falls by `fall`.
  void add_piece(std::size_t row, double from, double to, double fall) {
    double* const difference = differences_.data() + row * (static_cast<std::size_t>(columns_) + 1);
    double x = std::min(from, to);
    double end = std::max(from, to);
    if (x == end) {
      add_to_cell(difference, x, x, fall);
      return;
    }
    const double slope = fall / (end - x);
    if (x < 0.0) {
      difference[0] += (std::min(end, 0.0) - x) * slope;
      x = std::min(end, 0.0);
    }
    end = std::min(end, static_cast<double>(columns_));
    while (x < end) {
      const double next = std::min(std::floor(x) + 1.0, end);
      add_to_cell(difference, x, next, (next - x) * slope);
      x = next;
    }
  }

  void add_to_cell(double* difference, double from, double to, double fall) const {
    if (from >= columns_) {
      return;
    }
    if (from < 0.0) {
      difference[0] += fall;
      return;
    }
    const auto column = static_cast<std::size_t>(from);
    const double left = 0.5 * (from + to) - static_cast<double>(column);  // of the edge, in this cell
    difference[column] += fall * (1.0 - left);
    difference[column + 1] += fall * left;
  }

  int first_column_, first_row_, columns_, rows_;
  std::vector<double> differences_;
};

void include(Bounds& bounds, const Point& point) {
  for (std::size_t k = 0; k < 2; ++k) {
    bounds.low[k] = std::min(bounds.low[k], point[k]);
    bounds.high[k] = std::max(bounds.high[k], point[k]);
  }
}

Bounds nothing() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {{infinity, infinity}, {-infinity, -infinity}};
}

}  // namespace

Bounds bounds_of(const PolygonLayer& layer) {
  Bounds bounds = nothing();
  for (const PolygonFeature& feature : layer.features) {
    for (const Ring& ring : feature.rings) {
      std::for_each(ring.begin(), ring.end(), [&](const Point& corner) { include(bounds, corner); });
    }
  }
  return bounds;
}

double area_of(const PolygonFeature& feature, const Grid& grid) {
  // Seen from a corner of the feature itself: coordinates far from the origin would cost digits.
  const Point base = corner_in_cells(feature.rings.front().front(), grid);
  double twice = 0.0;
  for_each_edge(feature, grid, [&](const Point& from, const Point& to) {
    twice += (from[0] - base[0]) * (to[1] - base[1]) - (to[0] - base[0]) * (from[1] - base[1]);
  });
  return 0.5 * twice * grid.spacing * grid.spacing;
}

void for_each_covered_cell(const PolygonFeature& feature, const Grid& grid,
                           const std::function<void(std::size_t cell, double part)>& action) {
  Bounds bounds = nothing();
  for_each_edge(feature, grid, [&](const Point&, const Point& to) { include(bounds, to); });
  std::array<int, 2> first{};
  std::array<int, 2> count{};
  for (std::size_t k = 0; k < 2; ++k) {
    const double cells = grid.cells[k];
    first[k] = static_cast<int>(std::floor(std::clamp(bounds.low[k], 0.0, cells)));
    count[k] = static_cast<int>(std::ceil(std::clamp(bounds.high[k], 0.0, cells))) - first[k];
    if (count[k] <= 0) {
      return;
    }
  }
  Window window(first[0], first[1], count[0], count[1]);
  for_each_edge(feature, grid, [&](const Point& from, const Point& to) { window.add_edge(from, to); });
  window.finish([&](int i, int j, double part) {
    if (part > 0.0) {
      action(static_cast<std::size_t>(j) * static_cast<std::size_t>(grid.cells[0]) + static_cast<std::size_t>(i), part);
    }
  });
}

}  // namespace sandsim
