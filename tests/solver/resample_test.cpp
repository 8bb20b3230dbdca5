#include "solver/resample.hpp"

#include <cmath>
#include <limits>
#include <random>

#include "tests/support/catch.hpp"

namespace sandsim {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Raster raster_of(std::size_t nx, std::size_t ny, std::vector<double> values, double spacing = 1.0) {
  return {nx, ny, 0.0, 0.0, spacing, spacing, true, std::move(values)};
}

Raster random_raster(std::size_t nx, std::size_t ny) {
  std::mt19937 bits(7);
  std::uniform_real_distribution<double> uniform(-10.0, 10.0);
  std::vector<double> values(nx * ny);
  for (double& value : values) {
    value = uniform(bits);
  }
  return raster_of(nx, ny, values);
}

TEST_CASE("a sample is bilinear between the centres") {
  const Raster raster = raster_of(2, 2, {0, 4, 8, 20});

  CHECK(sample(raster, 0.5, 0.0) == 2.0);
  CHECK(sample(raster, 0.0, 0.25) == 2.0);
  CHECK(sample(raster, 0.25, 0.5) == 0.5 * (1.0 + 11.0));
}

TEST_CASE("a sample on a centre has the bits of the value") {
  const Raster raster = random_raster(5, 4);

  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t column = 0; column < 5; ++column) {
      const double value = raster.at(column, row);
      CHECK(sample(raster, static_cast<double>(column), static_cast<double>(row)) == value);
      CHECK(sample(raster, static_cast<double>(column) + 5e-10, static_cast<double>(row) - 5e-10) == value);
    }
  }
}

TEST_CASE("the outermost half cell takes the value of the edge and beyond it there is none") {
  const Raster raster = raster_of(2, 1, {3, 5});

  CHECK(sample(raster, -0.5, 0.5) == 3.0);
  CHECK(sample(raster, 1.5, -0.5) == 5.0);
  CHECK(std::isnan(sample(raster, -0.51, 0.0)));
  CHECK(std::isnan(sample(raster, 1.51, 0.0)));
  CHECK(std::isnan(sample(raster, 0.0, 0.51)));
  CHECK(std::isnan(sample(raster, 0.0, -0.51)));
  CHECK(std::isnan(sample(raster, nan, 0.0)));
}

TEST_CASE("a missing value spreads only to points that need it") {
  const Raster raster = raster_of(3, 2, {1, 2, nan, 4, 5, 6});

  CHECK(sample(raster, 1.0, 0.5) == 3.5);
  CHECK(sample(raster, 1.5, 1.0) == 5.5);
  CHECK(std::isnan(sample(raster, 1.5, 0.5)));
  CHECK(std::isnan(sample(raster, 2.0, 0.5)));
}

TEST_CASE("a raster of one value is that value to the last bit") {
  const double value = 0.1;
  const Raster raster = raster_of(3, 3, std::vector<double>(9, value));

  for (const double x : {0.1, 0.3, 0.7, 1.9}) {
    CHECK(sample(raster, x, 2.0 - x) == value);
  }
}

TEST_CASE("mirrored and transposed rasters give the same bits") {
  const Raster raster = random_raster(4, 4);
  Raster mirrored = raster;
  Raster transposed = raster;
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      mirrored.values[row * 4 + column] = raster.at(3 - column, row);
      transposed.values[row * 4 + column] = raster.at(row, column);
    }
  }

  for (const double x : {0.125, 0.375, 1.6875, 2.75}) {
    for (const double y : {0.0, 0.25, 1.3125, 3.0}) {
      CHECK(sample(mirrored, 3.0 - x, y) == sample(raster, x, y));
      CHECK(sample(transposed, y, x) == sample(raster, x, y));
    }
  }
}

TEST_CASE("a georeferenced raster with the grid's centres keeps its bits far from the origin") {
  // Map coordinates lose 1e-9 m to rounding, more than 1e-9 of a cell of 1 cm.
  const Grid grid{{40, 30}, 0.01, {412345.67, 5412345.67}};
  Raster raster = random_raster(40, 30);
  raster.spacing_x = raster.spacing_y = 0.01;
  raster.origin_x = 412345.67 + 0.005;
  raster.origin_y = 5412345.67 + 0.005;

  CHECK(resample(raster, grid) == raster.values);
}

TEST_CASE("resampling a plane gives the plane at the cell centres") {
  std::vector<double> plane;
  for (int j = 0; j < 10; ++j) {
    for (int i = 0; i < 10; ++i) {
      plane.push_back(2.0 * i - 3.0 * j);
    }
  }
  const Raster raster = raster_of(10, 10, plane);
  const Grid grid{{7, 5}, 0.3, {1.0, 2.0}};

  const std::vector<double> values = resample(raster, grid);

  REQUIRE(values.size() == 35);
  for (int j = 0; j < 5; ++j) {
    for (int i = 0; i < 7; ++i) {
      // A handful of roundings of numbers up to 30.
      CHECK_THAT(values[j * 7 + i], WithinAbs(2.0 * grid.x(i) - 3.0 * grid.y(j), 1e-13));
    }
  }
}

TEST_CASE("a raster without georeference is taken as it is and must have the grid's size") {
  Raster raster = raster_of(2, 1, {nan, 0.1});
  raster.has_georeference = false;
  const Grid same{{2, 1}, 0.5, {10.0, 0.0}};

  CHECK(fits(raster, same));
  CHECK(std::isnan(resample(raster, same)[0]));
  CHECK(resample(raster, same)[1] == 0.1);
  CHECK_FALSE(fits(raster, Grid{{1, 2}, 0.5, {0.0, 0.0}}));
  CHECK_FALSE(fits(raster, Grid{{4, 1}, 0.5, {0.0, 0.0}}));
}

}  // namespace
}  // namespace sandsim
