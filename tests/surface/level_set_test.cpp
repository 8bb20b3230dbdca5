#include "solver/surface/level_set.hpp"

#include <omp.h>

#include <cmath>

#include "solver/objects/distance.hpp"
#include "support.hpp"
#include "tests/support/catch.hpp"

using namespace sandsim;
using namespace sandsim::surface;
using namespace sandsim::test;
using Catch::Matchers::WithinRel;
using objects::DistanceGrid;
using objects::Vec3;

namespace {

template <class Visit>
void for_each_sample(const DistanceGrid& grid, Visit visit) {
  std::size_t sample = 0;
  for (int k = 0; k < grid.points[2]; ++k) {
    for (int j = 0; j < grid.points[1]; ++j) {
      for (int i = 0; i < grid.points[0]; ++i, ++sample) {
        visit(grid.origin + grid.spacing * Vec3{1.0 * i, 1.0 * j, 1.0 * k}, static_cast<double>(grid.values[sample]));
      }
    }
  }
}

}  // namespace

TEST_CASE("a level layer has the signed distance of its box") {
  // 6 m x 4 m, sand from 0 to 3 m.
  const SurfaceMesh mesh = sand_mesh(flat_field(6, 4, std::vector<double>(24, 3.0)), 0.1);
  const double band = 1.25;
  const DistanceGrid grid = level_set(mesh, {0.5, band});
  CHECK(grid.points == std::array<int, 3>{21, 17, 15});  // 4 samples beyond the box on each side
  objects::Primitive box;
  box.kind = objects::PrimitiveKind::box;
  box.size = {3.0, 2.0, 1.5};
  box.pose.position = {3.0, 2.0, 1.5};
  double largest_error = 0.0;
  int within_the_band = 0;
  for_each_sample(grid, [&](const Vec3& p, double value) {
    const double exact = objects::distance(box, p);
    within_the_band += std::abs(exact) < band ? 1 : 0;
    largest_error = std::fmax(largest_error, std::abs(value - std::fmax(-band, std::fmin(band, exact))));
  });
  CHECK(within_the_band > 1000);
  // TriangleTree's part of a distance, and float32.
  CHECK(largest_error <= 5e-4 * band + 1e-6);
}

TEST_CASE("a cone of sand has the distance of a cone to the second order of the cells") {
  // Slope 1/2; the error of a mesh of chords, and of the half-cell band, falls with the cells. Looked at beside the
  // slant, away from the tip and the foot where the cells round the cone off.
  const auto largest_error = [](int cells) {
    Grid grid;
    grid.cells = {cells, cells};
    grid.spacing = 8.0 / cells;
    std::vector<double> depth;
    const auto height = [](double x, double y) { return std::max(0.0, 1.5 - 0.5 * std::hypot(x - 4.0, y - 4.0)); };
    for (int j = 0; j < cells; ++j) {
      for (int i = 0; i < cells; ++i) depth.push_back(height(grid.x(i), grid.y(j)));
    }
    const std::vector<double> bed(depth.size(), 0.0);
    const SurfaceMesh mesh = sand_mesh(height_field(grid, bed, depth), 0.1 * grid.spacing);
    double largest = 0.0;
    for_each_sample(level_set(mesh, {0.1, 0.3}), [&](const Vec3& p, double value) {
      const double radius = std::hypot(p.x - 4.0, p.y - 4.0);
      const double exact = (p.z - (1.5 - 0.5 * radius)) / std::sqrt(1.25);
      // The foot of the perpendicular, and the ground, have to be farther away than the slant.
      if (radius < 1.0 || radius > 2.0 || std::abs(exact) > 0.2 || p.z < 0.35) return;
      largest = std::fmax(largest, std::abs(value - exact));
    });
    return largest;
  };
  const double coarse = largest_error(32), fine = largest_error(64);
  INFO(coarse << " " << fine);
  CHECK(coarse < 0.01);
  // A quarter; the tree's 5e-4 of 0.2 m is left.
  CHECK(fine < 0.3 * coarse + 1e-4);
}

TEST_CASE("the samples inside have the volume of rough sand") {
  const int nx = 9, ny = 8;
  const SurfaceMesh mesh = sand_mesh(flat_field(nx, ny, rough_depth(nx, ny, 7)), 0.1);
  const double spacing = 0.1;
  const DistanceGrid grid = level_set(mesh, {spacing, 0.3});
  double inside = 0.0;
  for_each_sample(grid, [&](const Vec3&, double value) { inside += value < 0.0 ? 1.0 : value == 0.0 ? 0.5 : 0.0; });
  // Samples that lie in the ground plane count half. Points miss a volume by some spacings of its surface at most; here
  // it is 1 %.
  CHECK_THAT(inside * spacing * spacing * spacing, WithinRel(volume_above_bed(mesh), 0.02));
}

TEST_CASE("no sample on an edge between triangles or on a node falls out") {
  // Samples in all nodes, sides and diagonals of the mesh.
  const SurfaceMesh mesh = sand_mesh(flat_field(6, 5, std::vector<double>(30, 1.0)), 0.1);
  const DistanceGrid grid = level_set(mesh, {0.25, 0.4});
  for_each_sample(grid, [](const Vec3& p, double value) {
    const bool is_inside = p.x > 0.0 && p.x < 6.0 && p.y > 0.0 && p.y < 5.0 && p.z > 0.0 && p.z < 1.0;
    CHECK((value < 0.0) == is_inside);
  });
}

TEST_CASE("about no sand everything is outside") {
  const SurfaceMesh mesh = sand_mesh(flat_field(3, 3, std::vector<double>(9, 0.0)), 0.1);
  const DistanceGrid grid = level_set(mesh, {0.5, 1.0});
  CHECK(grid.points == std::array<int, 3>{2, 2, 2});
  CHECK(grid.values == std::vector<float>(8, 1.0F));
}

TEST_CASE("a level set has the same bits on one thread and on several") {
  const SurfaceMesh mesh = sand_mesh(flat_field(9, 8, rough_depth(9, 8, 5)), 0.1);
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  const DistanceGrid one = level_set(mesh, {0.25, 1.0});
  omp_set_num_threads(3);
  const DistanceGrid three = level_set(mesh, {0.25, 1.0});
  omp_set_num_threads(before);
  CHECK(one.values == three.values);
}

TEST_CASE("a grid too fine to be held is told by its size alone") {
  const SurfaceMesh mesh = sand_mesh(flat_field(6, 4, std::vector<double>(24, 3.0)), 0.1);
  const DistanceGrid grid = level_set_grid(mesh, {1e-12, 1.0});
  CHECK(grid.points[0] == 1'000'000'000);
  CHECK(grid.values.empty());
}
