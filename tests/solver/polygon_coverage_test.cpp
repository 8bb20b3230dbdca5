#include "solver/polygon_coverage.hpp"

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "solver/coverage.hpp"
#include "tests/support/catch.hpp"

namespace sandsim {
namespace {

std::vector<double> coverage(const PolygonFeature& feature, const Grid& grid) {
  std::vector<double> parts(grid.cell_count(), 0.0);
  for_each_covered_cell(feature, grid, [&](std::size_t cell, double part) { parts[cell] += part; });
  return parts;
}

double sum(const std::vector<double>& values) {
  double result = 0.0;
  for (const double value : values) {
    result += value;
  }
  return result;
}

Ring rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}
Ring reversed(Ring ring) {
  return {ring.rbegin(), ring.rend()};
}

TEST_CASE("a rectangle covers cells by its overlap") {
  const Grid grid{{4, 3}, 2.0, {10.0, 20.0}};
  const PolygonFeature feature{{rectangle(11.0, 22.0, 16.0, 22.5)}};
  CHECK(coverage(feature, grid) == std::vector<double>{0, 0, 0, 0, 0.125, 0.25, 0.25, 0, 0, 0, 0, 0});
  CHECK(area_of(feature, grid) == 2.5);
}

TEST_CASE("a triangle covers cells by the part under its edge") {
  const Grid grid{{2, 2}, 1.0, {0.0, 0.0}};
  CHECK(coverage({{{{0, 0}, {2, 0}, {0, 2}}}}, grid) == std::vector<double>{1.0, 0.5, 0.5, 0.0});
  // Its hypotenuse crosses the faces at thirds.
  const std::vector<double> flat = coverage({{{{0, 0}, {1.5, 0}, {0, 1}}}}, grid);
  CHECK_THAT(flat[0], WithinAbs(2.0 / 3.0, 1e-9));  // corners and parts are rounded, to 2^-30 and 2^-40
  CHECK_THAT(flat[1], WithinAbs(1.0 / 12.0, 1e-9));
}

TEST_CASE("holes and several polygons add up with their signs") {
  const Grid grid{{4, 4}, 1.0, {0.0, 0.0}};
  PolygonFeature feature{{rectangle(0, 0, 3, 3), reversed(rectangle(1, 1, 2, 2)), rectangle(3.5, 3.5, 4, 4)}};
  CHECK(coverage(feature, grid) == std::vector<double>{1, 1, 1, 0, 1, 0, 1, 0, 1, 1, 1, 0, 0, 0, 0, 0.25});
  CHECK(area_of(feature, grid) == 8.25);
}

TEST_CASE("a polygon that reaches beyond the grid covers what is on it") {
  const Grid grid{{3, 2}, 1.0, {0.0, 0.0}};
  CHECK(coverage({{rectangle(-5, -7, 50, 60)}}, grid) == std::vector<double>(6, 1.0));
  CHECK(coverage({{rectangle(-5, 0.5, 0.5, 9)}}, grid) == std::vector<double>{0.25, 0, 0, 0.5, 0, 0});
  CHECK(sum(coverage({{rectangle(-5, 0, -1, 2)}}, grid)) == 0.0);
  CHECK(sum(coverage({{rectangle(3, 0, 9, 2)}}, grid)) == 0.0);
  // Oblique edges that enter and leave through the sides: a square on its tip about the corner of the grid.
  CHECK(coverage({{{{-2, 0}, {0, -2}, {2, 0}, {0, 2}}}}, grid) == std::vector<double>{1, 0.5, 0, 0.5, 0, 0});
}

TEST_CASE("a polygon of many corners has the coverage of the disc that it goes about") {
  const Grid grid{{20, 20}, 0.1, {412345.6, 5412345.6}};
  Ring ring;
  constexpr int corners = 40000;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / corners;
    ring.push_back({412346.63 + 0.7 * std::cos(angle), 5412346.57 + 0.7 * std::sin(angle)});
  }
  const std::vector<double> parts = coverage({{ring}}, grid);
  for (int j = 0; j < 20; ++j) {
    for (int i = 0; i < 20; ++i) {
      // A polygon of n corners lies up to 5/n^2 of the radius inside; coordinates are multiples of 1e-9 m here.
      const double exact = covered_by_disc({i + 0.5 - 10.3, j + 0.5 - 9.7}, 7.0);
      CHECK_THAT(parts[static_cast<std::size_t>(j * 20 + i)], WithinAbs(exact, 1e-6));
    }
  }
}

TEST_CASE("the parts of random stars add up to their area") {
  std::mt19937 bits(5);
  std::uniform_real_distribution<double> uniform(0.2, 9.0);
  const Grid grid{{21, 21}, 1.0, {-10.3, -10.7}};
  for (int k = 0; k < 50; ++k) {
    Ring ring;
    const int corners = 3 + k;
    for (int n = 0; n < corners; ++n) {
      const double angle = 2.0 * std::numbers::pi * n / corners;
      const double radius = uniform(bits);
      ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    const PolygonFeature feature{{ring}};
    // Parts are rounded to 2^-40.
    CHECK_THAT(sum(coverage(feature, grid)), WithinAbs(area_of(feature, grid), 441 * 1e-12));
  }
}

}  // namespace
}  // namespace sandsim
