#include "solver/resample.hpp"

#include <cmath>
#include <limits>
#include <numeric>
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

Raster mirrored_in_x(const Raster& raster) {
  Raster mirrored = raster;
  for (std::size_t row = 0; row < raster.ny; ++row) {
    for (std::size_t column = 0; column < raster.nx; ++column) {
      mirrored.values[row * raster.nx + column] = raster.at(raster.nx - 1 - column, row);
    }
  }
  return mirrored;
}

Raster transposed_square(const Raster& raster) {
  Raster transposed = raster;
  for (std::size_t row = 0; row < raster.ny; ++row) {
    for (std::size_t column = 0; column < raster.nx; ++column) {
      transposed.values[row * raster.nx + column] = raster.at(row, column);
    }
  }
  return transposed;
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

TEST_CASE("beside a value that is missing the others count, as far as their own cells reach") {
  const Raster raster = raster_of(3, 2, {1, 2, nan, 4, 5, 6});

  CHECK(sample(raster, 1.0, 0.5) == 3.5);
  CHECK(sample(raster, 1.5, 1.0) == 5.5);
  CHECK(sample(raster, 1.25, 0.0) == 2.0);                             // as beyond the raster's edge
  CHECK_THAT(sample(raster, 1.5, 0.5), WithinRel(13.0 / 3.0, 1e-15));  // the mean of 2, 5 and 6
  // Weights 9/16, 3/16 and 1/16 of 2, 5 and 6; 3/16 is missing.
  CHECK_THAT(sample(raster, 1.25, 0.25), WithinRel((9 * 2 + 3 * 5 + 6) / 13.0, 1e-15));
  CHECK(sample(raster, 2.0, 0.5) == 6.0);  // on the edge of the cell with data
  CHECK(std::isnan(sample(raster, 1.51, 0.0)));
  CHECK(std::isnan(sample(raster, 1.75, 0.25)));
  CHECK(std::isnan(sample(raster, 2.0, 0.49)));
}

TEST_CASE("a missing neighbour that hardly counts spoils nothing") {
  // The grid's origin is 0.1 mm off the raster's cells of 10 m: weights of 1e-5.
  Raster raster = raster_of(4, 2, {nan, 7, 7, 7, nan, 7, 7, 7}, 10.0);
  raster.origin_x = raster.origin_y = 5.0;
  for (const double x : {10.0, 9.9999, 10.0001}) {
    CHECK(resample(raster, Grid{{3, 2}, 10.0, {x, 0.0}}) == std::vector<double>(6, 7.0));
  }
  // Cells of half the size: those in the outer half of a cell with data have its value.
  CHECK(resample(raster, Grid{{6, 4}, 5.0, {10.0, 0.0}}) == std::vector<double>(24, 7.0));
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
  const Raster mirrored = mirrored_in_x(raster), transposed = transposed_square(raster);

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

TEST_CASE("a raster finer than the cells is averaged by area") {
  Raster raster = raster_of(4, 2, {1, 2, 3, 4, 5, 6, 7, 8}, 0.5);
  raster.origin_x = raster.origin_y = 0.25;
  CHECK(resample(raster, Grid{{2, 1}, 1.0, {0.0, 0.0}}) == std::vector<double>{3.5, 5.5});
  // Cells from 0.25 m on: 1/2, 1 and 1/2 of the columns, and the last one only to three quarters with data.
  CHECK_THAT(resample(raster, Grid{{2, 1}, 1.0, {0.25, 0.0}})[0], WithinRel(4.0, 1e-15));
  CHECK_THAT(resample(raster, Grid{{2, 1}, 1.0, {0.25, 0.0}})[1], WithinRel((0.5 * 5 + 6) / 1.5, 1e-15));
  // Half of the first cell has data, a quarter of the second.
  raster.values = {nan, nan, nan, nan, 5, 6, nan, 8};
  const std::vector<double> values = resample(raster, Grid{{2, 1}, 1.0, {0.0, 0.0}});
  CHECK(values[0] == 5.5);
  CHECK(std::isnan(values[1]));
}

TEST_CASE("a mean of equal values has their bits") {
  const Raster raster = raster_of(9, 9, std::vector<double>(81, 0.1), 0.3);
  const Grid grid{{2, 2}, 1.0, {0.0, 0.1}};
  CHECK(resample(raster, grid) == std::vector<double>(4, 0.1));
}

TEST_CASE("a spread raster keeps its volume for any size and shift of the cells") {
  Raster raster = random_raster(40, 30);
  double volume = 0.0;
  for (std::size_t k = 0; k < raster.values.size(); ++k) {
    raster.values[k] = k % 7 == 0 ? nan : std::abs(raster.values[k]);
    volume += k % 7 == 0 ? 0.0 : raster.values[k];
  }
  for (const double spacing : {0.1, 0.37, 1.0, 1.7, 25.0}) {
    for (const double shift : {0.0, 0.5, 0.123}) {
      const int nx = static_cast<int>(std::ceil(45.0 / spacing));
      const Grid grid{{nx, nx}, spacing, {-1.5 - shift * spacing, -1.5 - shift * spacing}};
      const SpreadRaster spread_out = spread(raster, grid);
      const double sum = std::accumulate(spread_out.depth.begin(), spread_out.depth.end(), 0.0);
      // Edges are rounded to 2^-30 of a cell.
      CHECK_THAT(sum * spacing * spacing + spread_out.outside, WithinRel(volume, 1e-8));
      if (spacing < 20.0) {
        CHECK_THAT(spread_out.outside, WithinAbs(0.0, 1e-8 * volume));
      }
    }
  }
}

TEST_CASE("what a raster holds beyond the grid is counted apart") {
  const Raster raster = raster_of(4, 1, {1, 2, 4, 8});
  // The grid covers half of the second column, and the third.
  const SpreadRaster spread_out = spread(raster, Grid{{3, 2}, 0.5, {1.0, -0.5}});
  CHECK(spread_out.depth == std::vector<double>{2, 4, 4, 2, 4, 4});
  CHECK(spread_out.outside == 1.0 + 0.5 * 2.0 + 8.0);
}

TEST_CASE("one value on a coarse cell is thinned to its volume, and a value on small cells is kept") {
  Raster raster = raster_of(1, 1, {2.0});
  raster.origin_x = raster.origin_y = 55.5;
  // Edges are rounded to 2^-30 of a cell, of which the value is a tenth wide.
  CHECK_THAT(spread(raster, Grid{{2, 2}, 10.0, {50.0, 50.0}}).depth[0], WithinRel(0.02, 1e-7));
  CHECK(spread(raster, Grid{{2, 2}, 0.5, {55.0, 55.0}}).depth == std::vector<double>(4, 2.0));
}

TEST_CASE("on the grid's own cells a spread raster has its bits also far from the origin") {
  const Grid grid{{40, 30}, 0.01, {412345.67, 5412345.67}};
  Raster raster = random_raster(40, 30);
  raster.spacing_x = raster.spacing_y = 0.01;
  raster.origin_x = 412345.67 + 0.005;
  raster.origin_y = 5412345.67 + 0.005;
  CHECK(spread(raster, grid).depth == raster.values);
  CHECK(spread(raster, grid).outside == 0.0);
}

TEST_CASE("mirrored and transposed rasters are spread and averaged alike to the last bit") {
  const Raster raster = random_raster(10, 10);
  const Raster mirrored = mirrored_in_x(raster), transposed = transposed_square(raster);
  const Grid grid{{4, 4}, 2.5, {-0.5, -0.5}};  // which ends with the raster
  const auto check = [](const std::vector<double>& a, const std::vector<double>& b, const std::vector<double>& c) {
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t i = 0; i < 4; ++i) {
        CHECK(b[j * 4 + i] == a[j * 4 + 3 - i]);
        CHECK(c[j * 4 + i] == a[i * 4 + j]);
      }
    }
  };
  check(spread(raster, grid).depth, spread(mirrored, grid).depth, spread(transposed, grid).depth);
  check(resample(raster, grid), resample(mirrored, grid), resample(transposed, grid));
}

TEST_CASE("in a 1-D scene the rows of a raster that meet the grid's row are averaged") {
  Raster raster = raster_of(2, 3, {1, 2, 3, 6, 100, 100}, 0.5);
  raster.origin_x = raster.origin_y = 0.25;  // rows to 0.5 m, 1 m and 1.5 m
  const SpreadRaster spread_out = spread(raster, Grid{{2, 1}, 1.0, {0.0, 0.0}});
  CHECK(spread_out.depth == std::vector<double>{3.0, 0.0});  // the mean of 1, 2, 3 and 6
  CHECK(spread_out.outside == 0.0);
}

TEST_CASE("the nearest value is the nearest by distance, and of equals the southernmost and then the westernmost") {
  Raster raster = raster_of(5, 5, std::vector<double>(25, nan));
  raster.values[0 * 5 + 2] = 1.0;
  raster.values[2 * 5 + 0] = 2.0;
  raster.values[2 * 5 + 4] = 3.0;
  raster.values[4 * 5 + 2] = 4.0;
  const NearestValue nearest(raster);
  CHECK(nearest.at(2.0, 2.0) == 1.0);  // all four are 2 m away
  CHECK(nearest.at(2.0, 2.1) == 4.0);
  CHECK(nearest.at(1.9, 2.0) == 2.0);
  CHECK(nearest.at(2.1, 2.0) == 3.0);
  CHECK(nearest.at(2.0, 2.0 + 1e-12) == 1.0);  // a tie but for rounding
  CHECK(nearest.at(-7.0, 2.0) == 2.0);         // beyond the raster
  CHECK(nearest.at(40.0, 50.0) == 4.0);        // 59.7 m away; 3.0 is 60 m

  // Against the distances to all cells, on random places and cells that are not square.
  std::mt19937 bits(3);
  std::uniform_real_distribution<double> uniform(-3.0, 12.0);
  Raster sparse = random_raster(10, 8);
  sparse.spacing_y = 0.7;
  for (double& value : sparse.values) {
    value = value < 7.0 ? nan : value;
  }
  const NearestValue of_sparse(sparse);
  for (int k = 0; k < 300; ++k) {
    const double x = uniform(bits), y = uniform(bits);
    double smallest = 1e9, value = nan;
    for (std::size_t row = 0; row < 8; ++row) {
      for (std::size_t column = 0; column < 10; ++column) {
        const double distance = std::hypot(static_cast<double>(column) - x, 0.7 * static_cast<double>(row) - y);
        if (!std::isnan(sparse.at(column, row)) && distance < smallest) {
          smallest = distance, value = sparse.at(column, row);
        }
      }
    }
    CHECK(of_sparse.at(x, y) == value);
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
