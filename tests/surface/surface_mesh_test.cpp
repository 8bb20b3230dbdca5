#include "solver/surface/surface_mesh.hpp"

#include <bit>
#include <cmath>
#include <numeric>

#include "support.hpp"
#include "tests/support/catch.hpp"

using namespace sandsim;
using namespace sandsim::surface;
using namespace sandsim::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double contour = 0.1;  // [m]

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

}  // namespace

TEST_CASE("each case of a square keeps the area that its crossings leave") {
  // Two by two cells of 1 m: depth 0.3 m where sand lies, so that the contour is 2/3 of the way to a dry centre. By
  // hand: the square between the centres, half-cell strips beside them, quarter-cell corners.
  const double part = 2.0 / 3.0;
  const auto area_of = [&](int kept) {
    const auto wet = [kept](int corner) { return (kept >> corner & 1) != 0; };
    double area = 0.0;
    for (int c = 0; c < 4; ++c) {
      const bool here = wet(c), next = wet((c + 1) % 4);
      if (here) area += 0.25;                                          // the corner of the domain
      area += 0.5 * (here && next ? 1.0 : here || next ? part : 0.0);  // the strip along one side
    }
    switch (std::popcount(static_cast<unsigned>(kept))) {
      case 1:
        return area + 0.5 * part * part;
      case 2:
        // Opposite corners: the mean, 0.15 m, exceeds the contour, and two triangles about the dry ones are left out.
        return area + (kept == 5 || kept == 10 ? 1.0 - (1.0 - part) * (1.0 - part) : part);
      case 3:
        return area + 1.0 - 0.5 * (1.0 - part) * (1.0 - part);
      default:
        return area + (kept == 15 ? 1.0 : 0.0);
    }
  };
  for (int kept = 0; kept < 16; ++kept) {
    INFO(kept);
    std::vector<double> depth(4, 0.0);
    const int cell_of_corner[] = {0, 1, 3, 2};
    for (int c = 0; c < 4; ++c) depth[cell_of_corner[c]] = (kept >> c & 1) != 0 ? 0.3 : 0.0;
    const SurfaceMesh mesh = sand_mesh(flat_field(2, 2, depth), contour);
    // To rounding of a handful of sums.
    CHECK_THAT(projected_area(mesh.shape), WithinAbs(area_of(kept), 1e-14));
    CHECK(is_manifold(mesh));
    CHECK(uses_each_vertex_once(mesh.shape));
    CHECK((mesh.shape.triangles.empty() || smallest_area(mesh.shape) > 1e-3));
  }
}

TEST_CASE("opposite corners with little sand between them stay apart") {
  // Mean 0.0625 m, below the contour.
  const SurfaceMesh apart = sand_mesh(flat_field(2, 2, {0.125, 0.0, 0.0, 0.125}), contour);
  const SurfaceMesh joined = sand_mesh(flat_field(2, 2, {0.3, 0.0, 0.0, 0.3}), contour);
  CHECK(is_manifold(apart));
  CHECK(apart.contour_edges == 6);  // three around each: two strips and the square
  CHECK(joined.contour_edges == 6);
  CHECK(projected_area(joined.shape) > 2.0 * projected_area(apart.shape));
  CHECK(joined.shape.triangles.size() == apart.shape.triangles.size() + 2);  // a hexagon for two triangles
}

TEST_CASE("a mesh of rough sand is manifold without doubled vertices whether it is closed or not") {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    INFO(seed);
    const int nx = 7 + static_cast<int>(seed % 5), ny = 4 + static_cast<int>(seed % 7);
    SurfaceMesh mesh = sand_mesh(flat_field(nx, ny, rough_depth(nx, ny, seed)), contour);
    CHECK(is_manifold(mesh));
    CHECK(uses_each_vertex_once(mesh.shape));
    // The smallest one: both sides cut at 1/256, in a half cell.
    CHECK(smallest_area(mesh.shape) > 0.25 / (256.0 * 256.0));
    CHECK(mesh.contour_edges > 0);
    CHECK(mesh.contour_edges < mesh.rim.size());
    const double volume = volume_above_bed(mesh);
    close(mesh);
    CHECK(mesh.rim.empty());
    CHECK(is_manifold(mesh));
    CHECK(uses_each_vertex_once(mesh.shape));
    CHECK(mesh.normals.size() == mesh.shape.vertices.size());
    // The same sum in another order.
    CHECK_THAT(enclosed_volume(mesh.shape), WithinRel(volume, 1e-12));
  }
}

TEST_CASE("depths at the contour make neither doubled points nor degenerate triangles") {
  std::vector<double> depth(36, 0.0);
  for (std::size_t k = 0; k < depth.size(); ++k) depth[k] = k % 3 == 0 ? contour : k % 3 == 1 ? 1.0 : 0.0;
  depth[14] = std::nextafter(contour, 1.0);
  SurfaceMesh mesh = sand_mesh(flat_field(6, 6, depth), contour);
  CHECK(is_manifold(mesh));
  CHECK(uses_each_vertex_once(mesh.shape));
  CHECK(smallest_area(mesh.shape) > 0.0);
  close(mesh);
  CHECK(uses_each_vertex_once(mesh.shape));
  CHECK(smallest_area(mesh.shape) > 0.0);
}

TEST_CASE("sand everywhere reaches the sides and has the volume of the cells but for the corners") {
  const int nx = 9, ny = 6;
  std::vector<double> depth;
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) depth.push_back(2.0 + 0.1 * i * i - 0.05 * j);
  }
  const SurfaceMesh mesh = sand_mesh(flat_field(nx, ny, depth), contour);
  CHECK(mesh.contour_edges == 0);
  CHECK(mesh.rim.size() == 2 * (nx + 1 + ny + 1));
  CHECK_THAT(projected_area(mesh.shape), WithinRel(54.0, 1e-14));
  const objects::Bounds box = objects::bounds(mesh.shape);
  CHECK(box.low.x == 0.0);
  CHECK(box.high.x == 9.0);
  CHECK(box.low.y == 0.0);
  CHECK(box.high.y == 6.0);
  // Along one diagonal triangles weigh a square's corners by 1/3 and 1/6 instead of 1/4: in the interior that cancels,
  // at the four corners of the domain 1/12 of the cells there is left, with alternating signs.
  const double corners = (depth.front() - depth[nx - 1] + depth.back() - depth[nx * (ny - 1)]) / 12.0;
  CHECK_THAT(volume_above_bed(mesh), WithinRel(sum(depth) + corners, 1e-14));
}

TEST_CASE("no sand is an empty mesh that can be closed") {
  SurfaceMesh mesh = sand_mesh(flat_field(4, 3, std::vector<double>(12, 0.0)), contour);
  close(mesh);
  CHECK(mesh.shape.vertices.empty());
  CHECK(mesh.shape.triangles.empty());
  CHECK(volume_above_bed(mesh) == 0.0);
}

TEST_CASE("a single cell of sand is a pyramid of four triangles cut at the contour") {
  std::vector<double> depth(25, 0.0);
  depth[12] = 1.0;
  const SurfaceMesh mesh = sand_mesh(flat_field(5, 5, depth), contour);
  CHECK(mesh.shape.vertices.size() == 5);
  CHECK(mesh.shape.triangles.size() == 4);
  CHECK(mesh.contour_edges == 4);
  // A base of diagonals 2 * 0.9 m; heights of 1 m at the tip and 0.1 m at the contour: mean (1 + 0.1 + 0.1)/3.
  CHECK_THAT(volume_above_bed(mesh), WithinRel(2.0 * 0.81 * 0.4, 1e-14));
  for (std::size_t v = 0; v < 5; ++v) {
    if (mesh.shape.vertices[v].z == 1.0) CHECK(mesh.normals[v] == std::array<float, 3>{0.0F, 0.0F, 1.0F});
  }
}

TEST_CASE("one row of cells becomes a band of its width") {
  const SurfaceMesh mesh = sand_mesh(flat_field(6, 1, {2.0, 2.0, 1.0, 0.0, 0.0, 0.0}), contour);
  CHECK(is_manifold(mesh));
  const objects::Bounds box = objects::bounds(mesh.shape);
  CHECK(box.low.y == 0.0);
  CHECK(box.high.y == 1.0);
  // Until 2.5 m, where 1 m lies, and 9/10 of the way to the next centre.
  CHECK_THAT(box.high.x, WithinAbs(3.4, 1e-14));
  // 5 m^3 but for the rim below the contour: a triangle of 0.1 m by 0.1 m.
  CHECK_THAT(volume_above_bed(mesh), WithinAbs(5.0 - 0.005, 1e-14));
}

TEST_CASE("one cell becomes a square") {
  const SurfaceMesh mesh = sand_mesh(flat_field(1, 1, {0.5}), contour);
  CHECK_THAT(volume_above_bed(mesh), WithinRel(0.5, 1e-15));
  CHECK(mesh.rim.size() == 8);
}

TEST_CASE("on a plane the normals are those of the plane and so is the height over it") {
  const int nx = 5, ny = 4;
  const Grid grid = unit_grid(nx, ny);
  std::vector<double> bed;
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) bed.push_back(0.75 * grid.x(i) - 0.5 * grid.y(j));
  }
  const SurfaceMesh sand = sand_mesh(height_field(grid, bed, std::vector<double>(bed.size(), 0.25)), contour);
  for (const SurfaceMesh& mesh : {sand, terrain_mesh(grid, bed)}) {
    CHECK(mesh.shape.vertices.size() == (nx + 2) * (ny + 2));
    CHECK(mesh.contour_edges == 0);
    for (const auto& normal : mesh.normals) {
      const double size = std::sqrt(1.0 + 0.75 * 0.75 + 0.5 * 0.5);
      // float32
      CHECK_THAT(normal[0], WithinAbs(-0.75 / size, 1e-7));
      CHECK_THAT(normal[1], WithinAbs(0.5 / size, 1e-7));
      CHECK_THAT(normal[2], WithinAbs(1.0 / size, 1e-7));
    }
    // To the sides as well: the bed goes on as it was.
    for (std::size_t v = 0; v < mesh.bed.size(); ++v) {
      const objects::Vec3& p = mesh.shape.vertices[v];
      CHECK_THAT(mesh.bed[v], WithinAbs(0.75 * p.x - 0.5 * p.y, 1e-14));
    }
  }
  for (std::size_t v = 0; v < sand.bed.size(); ++v) {
    CHECK_THAT(sand.shape.vertices[v].z - sand.bed[v], WithinAbs(0.25, 1e-14));
  }
}

TEST_CASE("points of the contour have the depth of the contour and the normal of the slope") {
  // A ridge along y whose surface falls by 0.5 m a cell on both sides.
  std::vector<double> depth;
  for (int j = 0; j < 5; ++j) depth.insert(depth.end(), {0.0, 0.5, 1.0, 0.5, 0.0});
  const SurfaceMesh mesh = sand_mesh(flat_field(5, 5, depth), contour);
  int points = 0;
  for (std::size_t v = 0; v < mesh.bed.size(); ++v) {
    if (mesh.shape.vertices[v].z > 0.4) continue;
    ++points;
    CHECK_THAT(mesh.shape.vertices[v].z, WithinAbs(contour, 1e-15));
    CHECK(mesh.normals[v][2] > 0.0F);
    CHECK(mesh.normals[v][0] * (mesh.shape.vertices[v].x - 2.5) > 0.0);  // away from the ridge
    CHECK(mesh.normals[v][1] == 0.0F);
  }
  CHECK(points == 14);  // both sides of seven rows of nodes
}

TEST_CASE("a given elevation is that of the mesh while depths tell where it ends") {
  const Grid grid = unit_grid(3, 3);
  const std::vector<double> bed(9, 1.0);
  const std::vector<double> depth(9, 0.5);
  const SurfaceMesh mesh = sand_mesh(height_field(grid, bed, depth, std::vector<double>(9, 4.0)), contour);
  for (const objects::Vec3& vertex : mesh.shape.vertices) CHECK(vertex.z == 4.0);
}

TEST_CASE("a mirrored field has a mirrored contour") {
  const int nx = 8, ny = 6;
  const std::vector<double> depth = rough_depth(nx, ny, 3);
  std::vector<double> mirrored(depth.size());
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) mirrored[j * nx + i] = depth[j * nx + nx - 1 - i];
  }
  const SurfaceMesh one = sand_mesh(flat_field(nx, ny, depth), contour);
  const SurfaceMesh other = sand_mesh(flat_field(nx, ny, mirrored), contour);
  CHECK(one.shape.vertices.size() == other.shape.vertices.size());
  CHECK(one.contour_edges == other.contour_edges);
  CHECK_THAT(projected_area(one.shape), WithinRel(projected_area(other.shape), 1e-13));
}
