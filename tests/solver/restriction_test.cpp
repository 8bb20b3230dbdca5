// Fine fields on coarse grids.
#include "solver/reference/restriction.hpp"

#include "solver/reference/compare.hpp"
#include "tests/support/catch.hpp"

using namespace sandsim;

namespace {

Grid grid_of(int nx, int ny, double spacing) {
  return {{nx, ny}, spacing, {0.0, 0.0}};
}

}  // namespace

TEST_CASE("a coarse cell has the mean of the fine cells in it") {
  const std::vector<double> row{1.0, 3.0, 5.0, 11.0};
  CHECK(restrict_to(grid_of(2, 1, 0.02), grid_of(4, 1, 0.01), row) == std::vector<double>{2.0, 8.0});
  const std::vector<double> plane{1.0, 3.0, 5.0, 7.0};
  CHECK(restrict_to(grid_of(2, 2, 0.01), grid_of(2, 2, 0.01), plane) == plane);
}

TEST_CASE("a restriction in two dimensions averages both ways") {
  std::vector<double> values(16);
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = static_cast<double>(k);
  // Rows 0 and 1, columns 0 and 1 hold 0, 1, 4 and 5.
  CHECK(restrict_to(grid_of(2, 2, 0.02), grid_of(4, 4, 0.01), values) == std::vector<double>{2.5, 4.5, 10.5, 12.5});
}

TEST_CASE("a restriction keeps the integral where cells do not nest") {
  // Three fine cells in two: the middle one counts by halves.
  const std::vector<double> means = restrict_to(grid_of(2, 1, 0.03), grid_of(3, 1, 0.02), std::vector{1.0, 2.0, 6.0});
  REQUIRE(means.size() == 2);
  CHECK_THAT(means[0], WithinRel(4.0 / 3.0, 1e-14));
  CHECK_THAT(means[1], WithinRel(14.0 / 3.0, 1e-14));
}

TEST_CASE("errors against a fine run are integrals over the area") {
  const Grid coarse = grid_of(2, 2, 0.5), fine = grid_of(4, 4, 0.25);
  const std::vector<double> known(16, 1.0), depth{1.0, 1.0, 1.0, 3.0};
  const ErrorReport report = compare_fine(coarse, depth, fine, known, 2.0, std::vector<double>{0.5});
  CHECK(report.against == "fine run");
  CHECK(report.time == 2.0);
  CHECK(*report.l1 == 0.5);
  CHECK(*report.l2 == 1.0);
  CHECK(*report.linf == 2.0);
  CHECK(*report.l1_relative == 0.5);
  CHECK(report.height->computed == 3.0);
  CHECK(report.height->reference == 1.0);
  REQUIRE(report.fronts.size() == 1);
  CHECK(report.fronts[0].computed == 1.0);
  CHECK(*report.fronts[0].reference == 1.0);
}
