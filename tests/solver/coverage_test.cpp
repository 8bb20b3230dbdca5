#include "solver/coverage.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/catch.hpp"

namespace sandsim {
namespace {

constexpr double pi = std::numbers::pi;

template <typename Covered>
double sum_over_cells(double x, double y, double radius, Covered covered) {
  const int reach = static_cast<int>(radius) + 2;
  double sum = 0.0;
  for (int j = -reach; j <= reach; ++j) {
    for (int i = -reach; i <= reach; ++i) {
      sum += covered(std::array<double, 2>{i + 0.5 - x, j + 0.5 - y}, radius);
    }
  }
  return sum;
}

double disc(const std::array<double, 2>& offset, double radius) {
  return covered_by_disc(offset, radius);
}
double cone(const std::array<double, 2>& offset, double radius) {
  return covered_by_cone(offset, radius);
}

TEST_CASE("discs and cones have their volume for any radius and place") {
  for (const double radius : {0.03, 0.2, 0.5, std::numbers::sqrt2, 1.0, 2.5, 7.3, 60.0}) {
    for (const double x : {0.0, 0.5, 0.25, 0.999, 0.123}) {
      for (const double y : {0.0, 0.5, 0.75, 0.456}) {
        // The edges' integrals are some radius^2 and radius^3 large, of which the cell's own is left: rounding costs
        // 1e-16 times that.
        CHECK_THAT(sum_over_cells(x, y, radius, disc), WithinRel(pi * radius * radius, 1e-11));
        CHECK_THAT(sum_over_cells(x, y, radius, cone), WithinRel(pi * radius * radius / 3.0, 1e-10));
      }
    }
  }
}

TEST_CASE("the covered part of a cell by a disc is exact") {
  CHECK(disc({3.0, 0.0}, 4.0) == 1.0);
  CHECK(disc({3.0, 0.0}, 2.5) == 0.0);
  CHECK_THAT(disc({0.0, 0.0}, 0.25), WithinRel(pi / 16.0, 1e-15));
  CHECK_THAT(disc({0.5, 0.0}, 0.25), WithinRel(pi / 32.0, 1e-15));
  CHECK_THAT(disc({0.5, -0.5}, 1.0), WithinRel(pi / 4.0, 1e-15));
  // A segment of height 1/2 of a disc of radius 1, all of it in the cell but its ends.
  const double segment = std::acos(0.5) - 0.5 * std::sqrt(0.75);
  const double ends = 2.0 * disc({1.0, 1.0}, 1.0);
  CHECK_THAT(disc({1.0, 0.0}, 1.0) + ends, WithinRel(segment, 1e-14));
}

TEST_CASE("the mean of a cone over a cell is exact") {
  CHECK(cone({3.0, 0.0}, 2.5) == 0.0);
  CHECK_THAT(cone({0.0, 0.0}, 0.25), WithinRel(pi / 48.0, 1e-14));
  // The mean distance from the centre of a unit square: (sqrt 2 + asinh 1) / 6.
  const double distance = (std::numbers::sqrt2 + std::asinh(1.0)) / 6.0;
  CHECK_THAT(cone({0.0, 0.0}, 2.0), WithinRel(1.0 - distance / 2.0, 1e-14));
  // From a corner it is twice that.
  CHECK_THAT(cone({-0.5, 0.5}, 2.0), WithinRel(1.0 - distance, 1e-14));
  CHECK(covered_by_cone(0.0, 2.0) == 1.0 - 0.25 / 2.0);
  CHECK(covered_by_cone(1.0, 2.0) == 0.5);
  CHECK(covered_by_cone(-2.0, 2.0) == 0.0625);
  CHECK(covered_by_cone(3.0, 2.0) == 0.0);
}

TEST_CASE("mirrored and transposed cells are covered alike to the last bit") {
  for (const double radius : {0.3, 1.7, 9.1}) {
    for (double x = 0.0; x < 10.0; x += 0.37) {
      for (double y = 0.0; y < 10.0; y += 0.53) {
        for (const auto covered : {disc, cone}) {
          const double part = covered({x, y}, radius);
          CHECK(covered({-x, y}, radius) == part);
          CHECK(covered({y, -x}, radius) == part);
          CHECK((part >= 0.0 && part <= 1.0));
        }
      }
    }
  }
}

}  // namespace
}  // namespace sandsim
