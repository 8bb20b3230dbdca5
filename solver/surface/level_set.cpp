#include "solver/surface/level_set.hpp"

#include <algorithm>
#include <cmath>

#include "solver/objects/triangle_tree.hpp"

namespace sandsim::surface {

namespace {

using objects::DistanceGrid;
using objects::TriangleMesh;
using objects::Vec3;

/// A column of samples. [m]
struct Column {
  // The sand above it; none unless low < high.
  double low = objects::endless;
  double high = -objects::endless;
  // What of the closed surface comes as near as the band, seen from above.
  double lowest_ground = objects::endless;
  double highest_ground = -objects::endless;
  double lowest_top = objects::endless;
  double highest_top = -objects::endless;
  bool is_near_rim = false;

  bool is_inside(double z) const { return z > low && z < high; }
  /// Whether a point is certain to be farther from the surface than the band.
  bool is_far(double z, double band) const {
    const bool is_beyond = z < lowest_ground - band || z > highest_top + band;
    return is_beyond || (!is_near_rim && z > highest_ground + band && z < lowest_top - band);
  }
};

/// What rounding may take away of a place in spacings: a column on an edge belongs to both triangles, never to none.
constexpr double rounding = 1e-9;

/// The first and the last sample, in spacings from the origin, that lie within [low, high].
struct Range {
  int first = 0;
  int last = -1;
};

Range range(double low, double high, double origin, double spacing, int points) {
  return {std::max(0, static_cast<int>(std::ceil((low - origin) / spacing - rounding))),
          std::min(points - 1, static_cast<int>(std::floor((high - origin) / spacing + rounding)))};
}

/// The columns under a box, seen from above, and those as far as `reach` beside it.
struct Area {
  Range columns;
  Range rows;

  Area(const DistanceGrid& grid, const objects::Bounds& box, double reach)
      : columns(range(box.low.x - reach, box.high.x + reach, grid.origin.x, grid.spacing, grid.points[0])),
        rows(range(box.low.y - reach, box.high.y + reach, grid.origin.y, grid.spacing, grid.points[1])) {}
};

double twice_area(double ax, double ay, double bx, double by) {
  return ax * by - ay * bx;
}

/// Knows of every column of samples what sand lies above it and what of its surface comes near.
class Columns {
 public:
  Columns(const SurfaceMesh& mesh, const DistanceGrid& grid, double band)
      : mesh_(mesh), grid_(grid), columns_(static_cast<std::size_t>(grid.points[0]) * grid.points[1]) {
    for (const auto& triangle : mesh.shape.triangles) {
      fill(triangle);
      spread(triangle, band);
    }
    for (const auto& [a, b] : mesh.rim) {
      objects::Bounds box;
      box.include(mesh.shape.vertices[a]);
      box.include(mesh.shape.vertices[b]);
      for_each(Area(grid, box, band), [](Column& column) { column.is_near_rim = true; });
    }
  }

  const Column& at(int i, int j) const { return columns_[static_cast<std::size_t>(j) * grid_.points[0] + i]; }

 private:
  using Triangle = std::array<std::uint32_t, 3>;

  template <class Visit>
  void for_each(const Area& area, Visit visit) {
    for (int j = area.rows.first; j <= area.rows.last; ++j) {
      for (int i = area.columns.first; i <= area.columns.last; ++i) {
        visit(columns_[static_cast<std::size_t>(j) * grid_.points[0] + i]);
      }
    }
  }

  objects::Bounds box_of(const Triangle& triangle) const {
    objects::Bounds box;
    for (const std::uint32_t corner : triangle) box.include(mesh_.shape.vertices[corner]);
    return box;
  }

  /// The sand above the columns under a triangle of the surface.
  void fill(const Triangle& triangle) {
    const Vec3& a = mesh_.shape.vertices[triangle[0]];
    const Vec3& b = mesh_.shape.vertices[triangle[1]];
    const Vec3& c = mesh_.shape.vertices[triangle[2]];
    const double area = twice_area(b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y);
    const Area below(grid_, box_of(triangle), 0.0);
    for (int j = below.rows.first; j <= below.rows.last; ++j) {
      const double y = grid_.origin.y + j * grid_.spacing;
      for (int i = below.columns.first; i <= below.columns.last; ++i) {
        const double x = grid_.origin.x + i * grid_.spacing;
        const double to_b = twice_area(x - a.x, y - a.y, c.x - a.x, c.y - a.y) / area;
        const double to_c = twice_area(b.x - a.x, b.y - a.y, x - a.x, y - a.y) / area;
        const double to_a = 1.0 - to_b - to_c;
        if (std::min({to_a, to_b, to_c}) < -rounding) continue;
        Column& column = columns_[static_cast<std::size_t>(j) * grid_.points[0] + i];
        column.low = to_a * mesh_.bed[triangle[0]] + to_b * mesh_.bed[triangle[1]] + to_c * mesh_.bed[triangle[2]];
        column.high = to_a * a.z + to_b * b.z + to_c * c.z;
      }
    }
  }

  /// Tells the columns that a triangle, and the ground below it, come as near as the band.
  void spread(const Triangle& triangle, double band) {
    const objects::Bounds box = box_of(triangle);
    const auto [lowest, highest] =
        std::minmax({mesh_.bed[triangle[0]], mesh_.bed[triangle[1]], mesh_.bed[triangle[2]]});
    for_each(Area(grid_, box, band), [&, low = lowest, high = highest](Column& column) {
      column.lowest_ground = std::min(column.lowest_ground, low);
      column.highest_ground = std::max(column.highest_ground, high);
      column.lowest_top = std::min(column.lowest_top, box.low.z);
      column.highest_top = std::max(column.highest_top, box.high.z);
    });
  }

  const SurfaceMesh& mesh_;
  const DistanceGrid& grid_;
  std::vector<Column> columns_;
};

}  // namespace

DistanceGrid level_set_grid(const SurfaceMesh& mesh, const LevelSetGrid& sampling) {
  DistanceGrid grid;
  grid.spacing = sampling.spacing;
  objects::Bounds box = objects::bounds(mesh.shape);
  if (box.empty()) {
    grid.points = {2, 2, 2};
    return grid;
  }
  for (std::size_t v = 0; v < mesh.bed.size(); ++v) box.low.z = std::min(box.low.z, mesh.bed[v]);
  const double margin = std::ceil(sampling.band / sampling.spacing) + 1.0;
  const auto points = [&](double low, double high) {
    // Far more than any grid may have, where that is asked for.
    const double count = std::ceil((high - low) / sampling.spacing - 1e-9) + 1.0 + 2.0 * margin;
    return static_cast<int>(std::min(count, 1e9));
  };
  grid.points = {points(box.low.x, box.high.x), points(box.low.y, box.high.y), points(box.low.z, box.high.z)};
  grid.origin = box.low - (margin * sampling.spacing) * Vec3{1.0, 1.0, 1.0};
  return grid;
}

DistanceGrid level_set(SurfaceMesh mesh, const LevelSetGrid& sampling) {
  DistanceGrid grid = level_set_grid(mesh, sampling);
  const int nx = grid.points[0], ny = grid.points[1], nz = grid.points[2];
  grid.values.assign(static_cast<std::size_t>(nx) * ny * nz, static_cast<float>(sampling.band));
  if (mesh.shape.triangles.empty()) return grid;
  const Columns columns(mesh, grid, sampling.band);
  close(mesh);
  const objects::TriangleTree tree(mesh.shape);
#pragma omp parallel for schedule(dynamic, 4)
  for (int j = 0; j < ny; ++j) {
    std::uint32_t nearest = 0;
    for (int k = 0; k < nz; ++k) {
      for (int i = 0; i < nx; ++i) {
        const Vec3 point = grid.origin + grid.spacing * Vec3{1.0 * i, 1.0 * j, 1.0 * k};
        const Column& column = columns.at(i, j);
        const double distance =
            column.is_far(point.z, sampling.band) ? sampling.band : tree.distance(point, nearest, sampling.band);
        grid.values[(static_cast<std::size_t>(k) * ny + j) * nx + i] =
            static_cast<float>(column.is_inside(point.z) ? -distance : distance);
      }
    }
  }
  return grid;
}

}  // namespace sandsim::surface
