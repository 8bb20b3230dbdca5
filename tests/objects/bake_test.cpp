#include "solver/objects/bake.hpp"

#include <omp.h>

#include <random>
#include <stdexcept>
#include <utility>

#include "solver/objects/shape.hpp"
#include "tests/objects/meshes.hpp"
#include "tests/objects/support.hpp"

using namespace sandsim::objects;
using namespace sandsim::test;

namespace {

using Exact = std::function<double(const Vec3&)>;

struct Comparison {
  double largest_error = 0.0;   // [m] of all samples
  std::size_t wrong_signs = 0;  // of samples farther from the surface than `tolerance`
};

Comparison compare(const DistanceGrid& grid, const Exact& exact, double tolerance) {
  Comparison result;
  std::size_t sample = 0;
  for (int k = 0; k < grid.points[2]; ++k) {
    for (int j = 0; j < grid.points[1]; ++j) {
      for (int i = 0; i < grid.points[0]; ++i, ++sample) {
        const double value = static_cast<double>(grid.values[sample]);
        const double expected = exact(grid.origin + grid.spacing * Vec3{1.0 * i, 1.0 * j, 1.0 * k});
        result.largest_error = std::fmax(result.largest_error, std::abs(value - expected));
        if (std::abs(expected) > tolerance && (value < 0) != (expected < 0)) ++result.wrong_signs;
      }
    }
  }
  return result;
}

const Exact unit_sphere = [](const Vec3& p) { return sphere_distance(1.0, p); };

void append(TriangleMesh& mesh, const TriangleMesh& other) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto& t : other.triangles) mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

}  // namespace

TEST_CASE("a sphere's mesh is baked to a thousandth of its diameter") {
  const BakedMesh baked = bake(sphere_mesh(1.0, 100), 48);
  CHECK(baked.defects.is_closed());
  CHECK(baked.defects.flipped_triangles == 0);
  const Comparison found = compare(baked.grid, unit_sphere, 1e-3);
  CHECK(found.largest_error < 2e-3);
  CHECK(found.wrong_signs == 0);
}

TEST_CASE("a torus's mesh is baked to a thousandth of its diameter") {
  const BakedMesh baked = bake(torus_mesh(1.0, 0.4, 120), 48);
  CHECK(baked.defects.is_closed());
  const Comparison found = compare(
      baked.grid, [](const Vec3& p) { return torus_distance(1.0, 0.4, p); }, 1e-3);
  CHECK(found.largest_error < 2.8e-3);
  CHECK(found.wrong_signs == 0);
  CHECK(baked.grid.points[0] == 48);
  CHECK(baked.grid.points[2] < 24);
}

TEST_CASE("between its samples a baked sphere keeps to a thousandth of its diameter") {
  const auto grid = std::make_shared<DistanceGrid>(bake(sphere_mesh(1.0, 100), 64).grid);
  const Shape shape(grid);
  Random random;
  for (int k = 0; k < 10000; ++k) {
    const Vec3 p = random.vector(1.0);
    // Near the centre the exact distance has a kink, where interpolation errs by the spacing.
    if (length(p) > 0.2) CHECK_THAT(distance(shape.view(), p), WithinAbs(unit_sphere(p), 2e-3));
  }
}

TEST_CASE("flipped triangles are turned round") {
  TriangleMesh mesh = sphere_mesh(1.0, 60);
  std::mt19937 random(1);
  std::size_t flipped = 0;
  for (auto& t : mesh.triangles) {
    if (random() % 50 != 0) continue;
    std::swap(t[1], t[2]);
    ++flipped;
  }
  const BakedMesh baked = bake(mesh, 40);
  // Those at the poles have no area and are left out.
  CHECK(10 * baked.defects.flipped_triangles > 9 * flipped);
  CHECK(compare(baked.grid, unit_sphere, 3e-3).wrong_signs == 0);
}

TEST_CASE("a mesh that is inside out is turned") {
  TriangleMesh mesh = sphere_mesh(1.0, 30);
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  const RepairedMesh repaired = repair(mesh);
  CHECK(repaired.defects.flipped_triangles == repaired.mesh.triangles.size());
  CHECK(compare(bake(mesh, 24).grid, unit_sphere, 3e-2).wrong_signs == 0);
}

TEST_CASE("of faces that look both ways those that look inwards are turned") {
  TriangleMesh mesh = box_mesh({1, 1, 1});
  for (std::size_t t = 0; t < 8; ++t) std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
  const RepairedMesh repaired = repair(mesh);
  CHECK(repaired.defects.flipped_triangles == 8);
  CHECK_THAT(signed_volume(repaired.mesh), WithinRel(1.0, 1e-15));
}

TEST_CASE("parts inside a mesh that is turned are turned with it") {
  // A cube of 4, in it a cavity of 2, in it a cube of 1; beside it a cube of 1 that is inside out alone.
  TriangleMesh cavity = box_mesh({2, 2, 2});
  for (auto& t : cavity.triangles) std::swap(t[1], t[2]);
  TriangleMesh mesh = box_mesh({4, 4, 4});
  append(mesh, cavity);
  append(mesh, box_mesh({1, 1, 1}));
  CHECK(repair(mesh).defects.flipped_triangles == 0);
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  TriangleMesh beside = box_mesh({1, 1, 1});
  for (auto& v : beside.vertices) v.x += 9;
  for (auto& t : beside.triangles) std::swap(t[1], t[2]);
  append(mesh, beside);
  const RepairedMesh repaired = repair(mesh);
  CHECK(repaired.defects.flipped_triangles == 4 * 12);
  // 64 - 8 + 1 + 1
  CHECK_THAT(signed_volume(repaired.mesh), WithinRel(58.0, 1e-14));
}

TEST_CASE("a mesh with a hole that is inside out is turned and a sheet is not") {
  TriangleMesh mesh = box_mesh({1, 1, 1});
  mesh.triangles.resize(10);  // no lid
  CHECK(repair(mesh).defects.flipped_triangles == 0);
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  CHECK(repair(mesh).defects.flipped_triangles == 10);
  const TriangleMesh sheet{{{0, 0, 0}, {1, 0, 0}, {0, 1, 1e-4}, {1, 1, 0}}, {{0, 1, 2}, {2, 1, 3}}};
  CHECK(repair(sheet).defects.flipped_triangles == 0);
}

TEST_CASE("a small hole changes signs only next to it") {
  TriangleMesh mesh = sphere_mesh(1.0, 60);
  std::erase_if(mesh.triangles, [&](const auto& t) { return length(mesh.vertices[t[0]] - Vec3{1, 0, 0}) < 0.12; });
  const BakedMesh baked = bake(mesh, 48);
  CHECK(baked.defects.open_edges > 4);
  // A sample counts if it is farther from the sphere than the hole is wide.
  CHECK(compare(baked.grid, unit_sphere, 0.12).wrong_signs == 0);
  // And elsewhere than at the hole every sample is right.
  const Comparison all = compare(baked.grid, unit_sphere, 3e-3);
  CHECK(all.wrong_signs < 100);
}

TEST_CASE("overlapping shells are one inside") {
  TriangleMesh mesh = sphere_mesh(1.0, 60);
  append(mesh, sphere_mesh(1.0, 60, {0.7, 0, 0}));
  append(mesh, sphere_mesh(0.3, 30, {0.3, 0, 0}));
  const BakedMesh baked = bake(mesh, 48);
  CHECK(baked.defects.is_closed());
  const Exact either = [](const Vec3& p) {
    return std::fmin(sphere_distance(1.0, p), sphere_distance(1.0, p - Vec3{0.7, 0, 0}));
  };
  CHECK(compare(baked.grid, either, 3e-3).wrong_signs == 0);
}

TEST_CASE("a shell turned inwards is a cavity") {
  TriangleMesh cavity = sphere_mesh(0.5, 40);
  for (auto& t : cavity.triangles) std::swap(t[1], t[2]);
  TriangleMesh mesh = sphere_mesh(1.0, 60);
  append(mesh, cavity);
  const Exact hollow = [](const Vec3& p) { return std::fmax(sphere_distance(1.0, p), -sphere_distance(0.5, p)); };
  CHECK(compare(bake(mesh, 40).grid, hollow, 3e-3).wrong_signs == 0);
}

TEST_CASE("open and non-manifold edges are counted") {
  const TriangleMesh two{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {2, 1, 3}}};
  CHECK(repair(two).defects.open_edges == 4);
  TriangleMesh three = two;
  three.vertices.push_back({0, 0, 1});
  three.triangles.push_back({1, 2, 4});
  CHECK(repair(three).defects.non_manifold_edges == 1);
  CHECK(repair(three).defects.open_edges == 6);
}

TEST_CASE("vertices at one place are one and triangles without a side are left out") {
  const TriangleMesh apart{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, 1, 0}, {1, 0, 0}, {1, 1, 0}},
                           {{0, 1, 2}, {3, 4, 5}, {2, 3, 0}}};
  const RepairedMesh repaired = repair(apart);
  CHECK(repaired.mesh.vertices.size() == 4);
  CHECK(repaired.defects.open_edges == 4);
  CHECK(repaired.defects.degenerate_triangles == 1);
}

TEST_CASE("meshes without extent and resolutions out of bounds are refused") {
  const TriangleMesh nothing;
  const TriangleMesh point{{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 1, 2}}};
  CHECK_THROWS_AS(bake(nothing, 32), std::invalid_argument);
  CHECK_THROWS_AS(bake(point, 32), std::invalid_argument);
  CHECK_THROWS_AS(bake(sphere_mesh(1, 8), least_resolution - 1), std::invalid_argument);
  CHECK_THROWS_AS(bake(sphere_mesh(1, 8), most_resolution + 1), std::invalid_argument);
}

TEST_CASE("any number of threads bakes the same bits") {
  const TriangleMesh mesh = torus_mesh(1.0, 0.3, 40);
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  const DistanceGrid one = bake(mesh, 32).grid;
  omp_set_num_threads(3);
  const DistanceGrid three = bake(mesh, 32).grid;
  omp_set_num_threads(before);
  CHECK(one.values == three.values);
}

TEST_CASE("progress rises to 1") {
  double last = 0.0;
  bake(sphere_mesh(1, 8), 16, [&](double fraction) {
    CHECK(fraction > last);
    last = fraction;
  });
  CHECK(last == 1.0);
}
