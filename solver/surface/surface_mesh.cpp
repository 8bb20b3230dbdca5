#include "solver/surface/surface_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sandsim::surface {

namespace {

using objects::Vec3;

/// What of a square is kept: a polygon, counterclockwise from the corner whose fan of triangles fills it. 0 to 3 are
/// the corners, counterclockwise from the lower left, 4 to 7 the points of the contour on the sides that follow them.
struct Polygon {
  int size = 0;
  std::array<int, 6> points{};
};

/// By the corners that are kept: 1 for the first, 2, 4 and 8 for the others. 5 and 10 are one of the two triangles.
constexpr std::array<Polygon, 16> polygons{{{},
                                            {3, {0, 4, 7}},
                                            {3, {1, 5, 4}},
                                            {4, {0, 1, 5, 7}},
                                            {3, {2, 6, 5}},
                                            {3, {0, 4, 7}},
                                            {4, {1, 2, 6, 4}},
                                            {5, {1, 2, 6, 7, 0}},
                                            {3, {3, 7, 6}},
                                            {4, {3, 0, 4, 6}},
                                            {3, {1, 5, 4}},
                                            {5, {0, 1, 5, 6, 3}},
                                            {4, {2, 3, 7, 5}},
                                            {5, {3, 0, 4, 5, 2}},
                                            {5, {2, 3, 7, 4, 1}},
                                            {4, {0, 1, 2, 3}}}};
/// Two opposite corners, joined, and the second triangle where they are not.
constexpr Polygon joined_5{6, {0, 4, 5, 2, 6, 7}};
constexpr Polygon joined_10{6, {1, 5, 6, 3, 7, 4}};
constexpr Polygon second_5{3, {2, 6, 5}};
constexpr Polygon second_10{3, {3, 7, 6}};

/// A point of the contour keeps this part of a side away from its ends. It exceeds the rounding of float32 coordinates
/// on a grid of 10^4 cells, 6e-8 of their size, six times.
constexpr double least_part = 1.0 / 256;

/// Builds the mesh row by row. Indices of vertices are kept for the two rows of nodes about a row of squares.
class Builder {
 public:
  Builder(const HeightField& field, double contour) : field_(field), contour_(contour) {
    const auto width = static_cast<std::size_t>(field.nx);
    for (Row* row : {&below_, &above_}) *row = Row(width);
    upright_.resize(width);
  }

  SurfaceMesh build() {
    reserve();
    for (int j = 0; j < field_.ny; ++j) {
      std::swap(below_, above_);
      add_row(j);
      if (j > 0) {
        add_upright_sides(j);
        add_squares(j - 1);
      }
    }
    mesh_.contour_edges = mesh_.rim.size();
    mesh_.rim.insert(mesh_.rim.end(), on_sides_.begin(), on_sides_.end());
    return std::move(mesh_);
  }

 private:
  struct Row {
    Row() = default;
    explicit Row(std::size_t width) : kept(width), nodes(width), sides(width) {}
    std::vector<unsigned char> kept;   // whether the depth of a node exceeds the contour
    std::vector<std::uint32_t> nodes;  // indices of their vertices
    std::vector<std::uint32_t> sides;  // of the contour's points between them and the next ones
  };

  bool is_kept(int i, int j) const { return field_.depth[field_.at(i, j)] > contour_; }

  /// Room for the nodes that are kept and a contour of common length.
  void reserve() {
    const auto kept = static_cast<std::size_t>(
        std::count_if(field_.depth.begin(), field_.depth.end(), [this](double depth) { return depth > contour_; }));
    const std::size_t vertices = kept + kept / 16;
    mesh_.shape.vertices.reserve(vertices);
    mesh_.normals.reserve(vertices);
    mesh_.bed.reserve(vertices);
    mesh_.shape.triangles.reserve(2 * vertices);
  }

  std::uint32_t add_vertex(const Vec3& point, double bed, const std::array<double, 2>& gradient) {
    const double scale = 1.0 / std::sqrt(gradient[0] * gradient[0] + gradient[1] * gradient[1] + 1.0);
    mesh_.shape.vertices.push_back(point);
    mesh_.bed.push_back(bed);
    mesh_.normals.push_back({static_cast<float>(-gradient[0] * scale), static_cast<float>(-gradient[1] * scale),
                             static_cast<float>(scale)});
    return static_cast<std::uint32_t>(mesh_.bed.size() - 1);
  }

  std::uint32_t add_node(int i, int j) {
    const std::size_t node = field_.at(i, j);
    return add_vertex({field_.x[i], field_.y[j], field_.elevation[node]}, field_.bed[node], field_.gradient(i, j));
  }

  /// The point of the contour between two nodes, of which one is kept.
  std::uint32_t add_crossing(int i, int j, int next_i, int next_j) {
    const std::size_t a = field_.at(i, j);
    const std::size_t b = field_.at(next_i, next_j);
    const double part =
        std::clamp((field_.depth[a] - contour_) / (field_.depth[a] - field_.depth[b]), least_part, 1.0 - least_part);
    const auto mix = [part](double from, double to) { return from + part * (to - from); };
    const std::array<double, 2> slope_a = field_.gradient(i, j);
    const std::array<double, 2> slope_b = field_.gradient(next_i, next_j);
    return add_vertex({mix(field_.x[i], field_.x[next_i]), mix(field_.y[j], field_.y[next_j]),
                       mix(field_.elevation[a], field_.elevation[b])},
                      mix(field_.bed[a], field_.bed[b]), {mix(slope_a[0], slope_b[0]), mix(slope_a[1], slope_b[1])});
  }

  void add_row(int j) {
    for (int i = 0; i < field_.nx; ++i) {
      above_.kept[i] = is_kept(i, j) ? 1 : 0;
      if (above_.kept[i]) above_.nodes[i] = add_node(i, j);
      if (i > 0 && above_.kept[i - 1] != above_.kept[i]) above_.sides[i - 1] = add_crossing(i - 1, j, i, j);
    }
  }

  void add_upright_sides(int j) {
    for (int i = 0; i < field_.nx; ++i) {
      if (below_.kept[i] != above_.kept[i]) upright_[i] = add_crossing(i, j - 1, i, j);
    }
  }

  void add_squares(int j) {
    for (int i = 0; i + 1 < field_.nx; ++i) {
      const int kept = below_.kept[i] | below_.kept[i + 1] << 1 | above_.kept[i + 1] << 2 | above_.kept[i] << 3;
      if (kept == 0) continue;
      if (kept == 15 && i > 0 && j > 0 && i + 2 < field_.nx && j + 2 < field_.ny) {
        add_whole(i);
        continue;
      }
      if (kept != 5 && kept != 10) {
        add(polygons[kept], i, j);
      } else if (is_joined(i, j)) {
        add(kept == 5 ? joined_5 : joined_10, i, j);
      } else {
        add(polygons[kept], i, j);
        add(kept == 5 ? second_5 : second_10, i, j);
      }
    }
  }

  bool is_joined(int i, int j) const {
    const double sum = field_.depth[field_.at(i, j)] + field_.depth[field_.at(i + 1, j)] +
                       field_.depth[field_.at(i, j + 1)] + field_.depth[field_.at(i + 1, j + 1)];
    return sum > 4.0 * contour_;
  }

  std::uint32_t vertex(int point, int i) const {
    switch (point) {
      case 0:
        return below_.nodes[i];
      case 1:
        return below_.nodes[i + 1];
      case 2:
        return above_.nodes[i + 1];
      case 3:
        return above_.nodes[i];
      case 4:
        return below_.sides[i];
      case 5:
        return upright_[i + 1];
      case 6:
        return above_.sides[i];
      default:
        return upright_[i];
    }
  }

  /// Most squares: all of their corners are kept, and no side is one of the domain's. The fan of add().
  void add_whole(int i) {
    const std::uint32_t first = below_.nodes[i], opposite = above_.nodes[i + 1];
    mesh_.shape.triangles.push_back({first, below_.nodes[i + 1], opposite});
    mesh_.shape.triangles.push_back({first, opposite, above_.nodes[i]});
  }

  void add(const Polygon& polygon, int i, int j) {
    std::array<std::uint32_t, 6> corners{};
    for (int k = 0; k < polygon.size; ++k) corners[k] = vertex(polygon.points[k], i);
    for (int k = 2; k < polygon.size; ++k) mesh_.shape.triangles.push_back({corners[0], corners[k - 1], corners[k]});
    for (int k = 0; k < polygon.size; ++k) {
      const int next = (k + 1) % polygon.size;
      add_rim(polygon.points[k], polygon.points[next], {corners[k], corners[next]}, i, j);
    }
  }

  /// An edge of a polygon between two points of the contour is part of it; others lie on a side of the square.
  void add_rim(int from, int to, const std::array<std::uint32_t, 2>& edge, int i, int j) {
    if (from >= 4 && to >= 4) {
      mesh_.rim.push_back(edge);
      return;
    }
    const int side = from % 4;
    const bool is_outer = side == 0 ? j == 0 : side == 1 ? i + 2 == field_.nx : side == 2 ? j + 2 == field_.ny : i == 0;
    if (is_outer) on_sides_.push_back(edge);
  }

  const HeightField& field_;
  double contour_;  // [m]
  SurfaceMesh mesh_;
  Row below_;
  Row above_;
  std::vector<std::uint32_t> upright_;  // points of the contour between nodes of the two rows
  std::vector<std::array<std::uint32_t, 2>> on_sides_;
};

/// Sums the normals of triangles, weighted by their areas, at their vertices.
std::vector<std::array<float, 3>> mean_normals(const objects::TriangleMesh& shape, std::size_t first_triangle,
                                               std::size_t first_vertex) {
  std::vector<Vec3> sums(shape.vertices.size() - first_vertex);
  for (std::size_t k = first_triangle; k < shape.triangles.size(); ++k) {
    const auto& t = shape.triangles[k];
    const Vec3 normal = cross(shape.vertices[t[1]] - shape.vertices[t[0]], shape.vertices[t[2]] - shape.vertices[t[0]]);
    for (const std::uint32_t corner : t) sums[corner - first_vertex] = sums[corner - first_vertex] + normal;
  }
  std::vector<std::array<float, 3>> normals;
  for (const Vec3& sum : sums) {
    const Vec3 unit = (1.0 / length(sum)) * sum;
    normals.push_back({static_cast<float>(unit.x), static_cast<float>(unit.y), static_cast<float>(unit.z)});
  }
  return normals;
}

}  // namespace

SurfaceMesh sand_mesh(const HeightField& field, double contour) {
  return Builder(field, contour).build();
}

SurfaceMesh terrain_mesh(const Grid& grid, std::span<const double> bed) {
  const std::vector<double> no_sand(bed.size(), 0.0);
  return Builder(height_field(grid, bed, no_sand), -std::numeric_limits<double>::infinity()).build();
}

void close(SurfaceMesh& mesh) {
  auto& [vertices, triangles] = mesh.shape;
  const auto upper = static_cast<std::uint32_t>(vertices.size());
  const std::size_t upper_triangles = triangles.size();
  for (std::uint32_t v = 0; v < upper; ++v) vertices.push_back({vertices[v].x, vertices[v].y, mesh.bed[v]});
  for (std::size_t k = 0; k < upper_triangles; ++k) {
    const auto [a, b, c] = triangles[k];
    triangles.push_back({a + upper, c + upper, b + upper});
  }
  const std::vector<std::array<float, 3>> down = mean_normals(mesh.shape, upper_triangles, upper);
  mesh.normals.insert(mesh.normals.end(), down.begin(), down.end());
  for (const auto& [a, b] : mesh.rim) {
    triangles.push_back({b, a, a + upper});
    triangles.push_back({b, a + upper, b + upper});
  }
  mesh.bed.resize(2 * static_cast<std::size_t>(upper));
  std::copy_n(mesh.bed.begin(), upper, mesh.bed.begin() + upper);
  mesh.rim.clear();
  mesh.contour_edges = 0;
}

double volume_above_bed(const SurfaceMesh& mesh) {
  const auto& [vertices, triangles] = mesh.shape;
  double volume = 0.0;
  for (const auto& t : triangles) {
    const Vec3 along = vertices[t[1]] - vertices[t[0]];
    const Vec3 across = vertices[t[2]] - vertices[t[0]];
    double height = 0.0;  // [m] three times the mean
    for (const std::uint32_t corner : t) height += vertices[corner].z - mesh.bed[corner];
    volume += (along.x * across.y - along.y * across.x) * height / 6.0;
  }
  return volume;
}

}  // namespace sandsim::surface
