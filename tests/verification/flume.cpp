// The flume: 0.4 m x 0.2 m of sand at a wall, 30.9 degrees, released on a flat bed; the deposit after 4 s against a
// converged one. Bounds: the acceptance numbers of the scheme, or the measured error plus 5 % where that is less.
#include <cmath>
#include <map>

#include "solver/reference/compare.hpp"
#include "tests/support/catch.hpp"
#include "tests/verification/cases.hpp"

using namespace sandsim;
using namespace sandsim::test;

namespace {

constexpr int finest = 1920;  // 0.625 mm; its own error is about a seventh of that at n = 480

Case flume(int n, bool truncated, Method method, Precision precision = Precision::float64) {
  Case test = make_case(n, 1, 1.2 / n, std::tan(30.9 / 180.0 * std::acos(-1.0)), method, precision);
  test.initial.depth = at_centers(test.grid(), [](double x, double) { return x < 0.4 ? 0.2 : 0.0; });
  if (truncated) {
    test.initial.hbar_scale = {0.8};
    test.initial.hbar_cap = {0.05};
  }
  return test;
}

const std::vector<double>& converged(bool truncated) {
  static std::map<bool, std::vector<double>> kept;
  std::vector<double>& deposit = kept[truncated];
  if (deposit.empty()) {
    Run run(flume(finest, truncated, Method::order2));
    run.until(4.0);
    deposit = run.depth();
  }
  return deposit;
}

double deposit_error(int n, bool truncated, Method method, Precision precision = Precision::float64) {
  Run run(flume(n, truncated, method, precision));
  run.until(4.0);
  // Every momentum is exactly zero long before.
  CHECK(run.backend().statistics().moving_cells == 0);
  Grid fine;
  fine.cells = {finest, 1};
  return relative_l1(run.depth(), coarsen(fine, converged(truncated), finest / n));
}

}  // namespace

TEST_CASE("the flume's deposit converges in order 2") {
  CHECK(deposit_error(60, false, Method::order2) <= 1.7e-2);
  CHECK(deposit_error(120, false, Method::order2) <= 8.0e-3);
  CHECK(deposit_error(240, false, Method::order2) <= 3.6e-3);
}

TEST_CASE("the flume's deposit converges in order 1") {
  CHECK(deposit_error(60, false, Method::order1) <= 3.6e-2);
  CHECK(deposit_error(120, false, Method::order1) <= 1.95e-2);
  CHECK(deposit_error(240, false, Method::order1) <= 1.1e-2);
}

TEST_CASE("the flume's deposit with a truncated dilute layer converges in both orders") {
  CHECK(deposit_error(60, true, Method::order2) <= 1.22e-2);
  CHECK(deposit_error(240, true, Method::order2) <= 2.6e-3);
  CHECK(deposit_error(60, true, Method::order1) <= 2.9e-2);
  CHECK(deposit_error(240, true, Method::order1) <= 9.0e-3);
}

TEST_CASE("single precision costs the flume's deposit nothing") {
  // Rounding of 6e-8 over a thousand steps stays far below the truncation error of 8e-3.
  CHECK(deposit_error(120, false, Method::order2, Precision::float32) <= 8.0e-3);
}

TEST_CASE("the paper's scheme needs its repairs to come near the flume's deposit") {
  CHECK(deposit_error(60, false, Method::repaired) <= 5.1e-2);
  CHECK(deposit_error(240, false, Method::repaired) <= 2.0e-2);
  CHECK(deposit_error(60, false, Method::printed) >= 0.2);
}

TEST_CASE("the converged deposit has the fronts of the reference table") {
  Grid grid;
  grid.cells = {finest, 1};
  grid.spacing = 1.2 / finest;
  // The table's fronts are rounded to 1 mm; at 5 mm depth the finest grid is within 2 mm, where the profile is thin.
  CHECK_THAT(front(grid, converged(false), 0.05), WithinAbs(0.514, 2e-3));
  CHECK_THAT(front(grid, converged(false), 0.005), WithinAbs(0.837, 4e-3));
  CHECK_THAT(front(grid, converged(true), 0.05), WithinAbs(0.526, 2e-3));
  CHECK_THAT(front(grid, converged(true), 0.005), WithinAbs(0.748, 4e-3));
}

TEST_CASE("the flume conserves volume to rounding") {
  for (const bool truncated : {false, true}) {
    for (const Method method : {Method::order2, Method::order1, Method::repaired}) {
      Run run(flume(120, truncated, method));
      run.until(4.0);
      // A few hundred steps each round 120 depths by 1e-16.
      CHECK_THAT(sum(run.depth()), WithinRel(sum(run.set_up().initial.depth), 1e-14));
    }
    Run single(flume(120, truncated, Method::order2, Precision::float32));
    single.until(4.0);
    CHECK_THAT(sum(single.depth()), WithinRel(sum(single.set_up().initial.depth), 1e-6));
  }
}
