#include "solver/surface/level_set.hpp"

#include <algorithm>
#include <cmath>

#include "solver/objects/triangle_tree.hpp"

namespace sandsim::surface {

namespace {

using objects::DistanceGrid;
using objects::TriangleMesh;
using objects::Vec3;

/// The sand above a column of samples; none unless low < high. [m]
struct Span {
  double low = objects::endless;
  double high = -objects::endless;
};

/// The first and the last sample, in spacings from the origin, that lie within [low, high].
struct Range {
  int first = 0;
  int last = -1;
};

Range range(double low, double high, double origin, double spacing, int points) {
  // Wider by what rounding may take away: a column on an edge belongs to both triangles, never to none.
  constexpr double rounding = 1e-9;
  return {std::max(0, static_cast<int>(std::ceil((low - origin) / spacing - rounding))),
          std::min(points - 1, static_cast<int>(std::floor((high - origin) / spacing + rounding)))};
}

double twice_area(double ax, double ay, double bx, double by) {
  return ax * by - ay * bx;
}

/// Sets the spans of the columns under one triangle of the surface.
void fill(std::vector<Span>& spans, const DistanceGrid& grid, const SurfaceMesh& mesh,
          const std::array<std::uint32_t, 3>& triangle) {
  constexpr double rounding = 1e-9;
  const Vec3& a = mesh.shape.vertices[triangle[0]];
  const Vec3& b = mesh.shape.vertices[triangle[1]];
  const Vec3& c = mesh.shape.vertices[triangle[2]];
  const auto [min_x, max_x] = std::minmax({a.x, b.x, c.x});
  const auto [min_y, max_y] = std::minmax({a.y, b.y, c.y});
  const Range columns = range(min_x, max_x, grid.origin.x, grid.spacing, grid.points[0]);
  const Range rows = range(min_y, max_y, grid.origin.y, grid.spacing, grid.points[1]);
  const double area = twice_area(b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y);
  for (int j = rows.first; j <= rows.last; ++j) {
    const double y = grid.origin.y + j * grid.spacing;
    for (int i = columns.first; i <= columns.last; ++i) {
      const double x = grid.origin.x + i * grid.spacing;
      const double to_b = twice_area(x - a.x, y - a.y, c.x - a.x, c.y - a.y) / area;
      const double to_c = twice_area(b.x - a.x, b.y - a.y, x - a.x, y - a.y) / area;
      const double to_a = 1.0 - to_b - to_c;
      if (std::min({to_a, to_b, to_c}) < -rounding) continue;
      Span& span = spans[static_cast<std::size_t>(j) * grid.points[0] + i];
      span.low = to_a * mesh.bed[triangle[0]] + to_b * mesh.bed[triangle[1]] + to_c * mesh.bed[triangle[2]];
      span.high = to_a * a.z + to_b * b.z + to_c * c.z;
    }
  }
}

std::vector<Span> spans_of(const SurfaceMesh& mesh, const DistanceGrid& grid) {
  std::vector<Span> spans(static_cast<std::size_t>(grid.points[0]) * grid.points[1]);
  for (const auto& triangle : mesh.shape.triangles) fill(spans, grid, mesh, triangle);
  return spans;
}

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
  const auto [nx, ny, nz] = grid.points;
  grid.values.assign(static_cast<std::size_t>(nx) * ny * nz, static_cast<float>(sampling.band));
  if (mesh.shape.triangles.empty()) return grid;
  const std::vector<Span> spans = spans_of(mesh, grid);
  close(mesh);
  const objects::TriangleTree tree(mesh.shape);
#pragma omp parallel for schedule(dynamic, 4)
  for (int j = 0; j < ny; ++j) {
    std::uint32_t nearest = 0;
    for (int k = 0; k < nz; ++k) {
      for (int i = 0; i < nx; ++i) {
        const Vec3 point = grid.origin + grid.spacing * Vec3{1.0 * i, 1.0 * j, 1.0 * k};
        const Span& span = spans[static_cast<std::size_t>(j) * nx + i];
        const double sign = point.z > span.low && point.z < span.high ? -1.0 : 1.0;
        grid.values[(static_cast<std::size_t>(k) * ny + j) * nx + i] =
            static_cast<float>(sign * tree.distance(point, nearest, sampling.band));
      }
    }
  }
  return grid;
}

}  // namespace sandsim::surface
