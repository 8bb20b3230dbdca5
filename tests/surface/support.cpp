#include "support.hpp"

#include <algorithm>
#include <random>
#include <set>
#include <tuple>

namespace sandsim::test {

using objects::TriangleMesh;
using objects::Vec3;

Grid unit_grid(int nx, int ny) {
  Grid grid;
  grid.cells = {nx, ny};
  grid.spacing = 1.0;
  return grid;
}

surface::HeightField flat_field(int nx, int ny, const std::vector<double>& depth) {
  return surface::height_field(unit_grid(nx, ny), std::vector<double>(depth.size(), 0.0), depth);
}

std::vector<double> rough_depth(int nx, int ny, unsigned seed) {
  std::mt19937 generator(seed);  // the standard fixes its numbers
  std::vector<double> depth(static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny));
  for (double& value : depth) value = std::max(0.0, static_cast<double>(generator() % 6000) / 1000.0 - 3.0);
  return depth;
}

Edges directed_edges(const TriangleMesh& mesh) {
  Edges edges;
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
  }
  return edges;
}

bool is_manifold(const surface::SurfaceMesh& mesh) {
  const Edges edges = directed_edges(mesh.shape);
  Edges open;
  for (const auto& [edge, times] : edges) {
    if (times != 1) return false;
    if (!edges.contains({edge.second, edge.first})) open[edge] = 1;
  }
  Edges rim;
  for (const auto& edge : mesh.rim) ++rim[{edge[0], edge[1]}];
  return open == rim;
}

double enclosed_volume(const TriangleMesh& mesh) {
  double volume = 0.0;
  for (const auto& t : mesh.triangles) {
    volume += dot(mesh.vertices[t[0]], cross(mesh.vertices[t[1]], mesh.vertices[t[2]])) / 6.0;
  }
  return volume;
}

double smallest_area(const TriangleMesh& mesh) {
  double smallest = objects::endless;
  for (const auto& t : mesh.triangles) {
    const Vec3& a = mesh.vertices[t[0]];
    smallest = std::min(smallest, 0.5 * length(cross(mesh.vertices[t[1]] - a, mesh.vertices[t[2]] - a)));
  }
  return smallest;
}

double projected_area(const TriangleMesh& mesh) {
  double area = 0.0;
  for (const auto& t : mesh.triangles) {
    const Vec3& a = mesh.vertices[t[0]];
    area += 0.5 * cross(mesh.vertices[t[1]] - a, mesh.vertices[t[2]] - a).z;
  }
  return area;
}

bool uses_each_vertex_once(const TriangleMesh& mesh) {
  std::set<std::tuple<double, double, double>> places;
  for (const Vec3& v : mesh.vertices) places.insert({v.x, v.y, v.z});
  std::set<std::uint32_t> used;
  for (const auto& t : mesh.triangles) used.insert(t.begin(), t.end());
  return places.size() == mesh.vertices.size() && used.size() == mesh.vertices.size();
}

}  // namespace sandsim::test
