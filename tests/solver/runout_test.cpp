// How far sand went: hand-made states on a slope of one metre a cell, and runs.
#include "solver/runout.hpp"

#include <atomic>
#include <cmath>
#include <numbers>

#include "solver/backends/cell_values.hpp"
#include "solver/simulation.hpp"
#include "support.hpp"
#include "tests/support/catch.hpp"

using namespace sandsim;
using namespace sandsim::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

/// Eight cells of 1 m; sand counts above 0.1 m.
Scene row_of_cells() {
  Scene scene;
  scene.grid = {{8, 1}, 1.0, {0.0, 0.0}};
  scene.numerics.precision = Precision::float64;
  scene.output.maxima = MaximaOutput{0.1};
  return scene;
}

/// The bed falls by 1 m a cell; 1 m of sand lies on the two highest.
InitialState on_a_slope() {
  InitialState initial;
  initial.bed = {7, 6, 5, 4, 3, 2, 1, 0};
  initial.depth.assign(8, 0.0);
  initial.depth[0] = initial.depth[1] = 1.0;
  return initial;
}

/// Sums of a few numbers of order 1 to 10 in float64.
constexpr double rounding = 1e-13;

}  // namespace

TEST_CASE("The runout goes from the top of the release to the outline of the deposit") {
  const Scene scene = row_of_cells();
  const InitialState initial = on_a_slope();
  RunoutMeter meter(scene, initial);
  meter.take(initial.depth, 1.0, 0.0);
  meter.take(std::vector<double>{0.05, 0, 0.5, 0.5, 0.5, 0.5, 0, 0}, 0.5, 3.0);
  const RunoutReport report = meter.report(std::vector<double>{0, 0, 0, 0, 0.5, 1, 0.5, 0}, {2.0, 2.0});
  // From cell 6 (x = 6.5, bed 1) to the next one 0.5 m of sand fall to 0.1 m over 0.8 of the way: x = 7.3, bed 0.2.
  CHECK_THAT(report.front.distance, WithinAbs(7.3 - 0.5, rounding));
  CHECK_THAT(report.front.drop, WithinAbs(8.0 - 0.2, rounding));
  CHECK_THAT(report.front.travel_angle(), WithinAbs(std::atan(7.8 / 6.8), rounding));
  CHECK_THAT(report.deposit_front, WithinAbs(7.3, rounding));
  // Centres of mass: (1, 7) at the start; (5.5, 2.375) at the end.
  CHECK_THAT(report.center_of_mass.distance, WithinAbs(4.5, rounding));
  CHECK_THAT(report.center_of_mass.drop, WithinAbs(4.625, rounding));
  CHECK(report.area == 7.0);
  CHECK(report.max_depth == 1.0);
  CHECK(report.max_speed == 3.0);
  CHECK(report.deposit_height == 1.0);
  CHECK(report.above == 0.1);
}

TEST_CASE("Sand that stays where it is has no runout and no angle") {
  const Scene scene = row_of_cells();
  const InitialState initial = on_a_slope();
  RunoutMeter meter(scene, initial);
  meter.take(initial.depth, 1.0, 0.0);
  const RunoutReport report = meter.report(initial.depth, {2.0, 2.0});
  CHECK(report.front.distance == 0.0);
  CHECK(report.front.drop == 0.0);
  CHECK(std::isnan(report.front.travel_angle()));
  CHECK(report.center_of_mass.distance == 0.0);
  CHECK(std::isnan(report.center_of_mass.travel_angle()));
  CHECK(report.area == 2.0);
}

TEST_CASE("Sand that leaves the grid has run as far as its edge") {
  const Scene scene = row_of_cells();
  const InitialState initial = on_a_slope();
  RunoutMeter meter(scene, initial);
  meter.take(initial.depth, 1.0, 0.0);
  meter.take(std::vector<double>{0, 0, 0, 0, 0, 0, 0.2, 0.3}, 0.3, 5.0);
  const RunoutReport report = meter.report(std::vector<double>(8, 0.0), {2.0, 0.0, 0.0, 2.0});
  CHECK_THAT(report.front.distance, WithinAbs(7.5 - 0.5, rounding));  // the centre of the last cell
  CHECK_THAT(report.front.drop, WithinAbs(8.0, rounding));
  CHECK(std::isnan(report.center_of_mass.distance));
  CHECK(std::isnan(report.deposit_front));
  CHECK(report.deposit_height == 0.0);
  CHECK(report.area == 4.0);
}

TEST_CASE("A release that is level on top runs out from its middle, and sources from where they are") {
  Scene scene = row_of_cells();
  InitialState initial;
  initial.depth = {1, 1, 0.995, 0, 0, 0, 0, 0};
  const RunoutReport collapse =
      RunoutMeter(scene, initial).report(std::vector<double>{1, 0.7, 0.5, 0.5, 0.3, 0.05, 0, 0}, {3.0, 3.0});
  // From 0.3 m to 0.05 m the depth falls to 0.1 m over 0.8 of a cell: x = 5.3; the top's middle is at 1.5.
  CHECK_THAT(collapse.front.distance, WithinAbs(3.8, rounding));
  CHECK_THAT(collapse.front.drop, WithinAbs(1.0, rounding));

  scene.output.maxima.reset();
  scene.sand.sources = {{{6.5, 0.0}, 0.1, 0.1, 0.0, 1.0}};
  initial.depth.assign(8, 0.0);
  CHECK(thin_depth(scene, initial) == 0.01);
  const RunoutReport pile =
      RunoutMeter(scene, initial).report(std::vector<double>{0, 0, 0, 0, 0.02, 0.3, 0.5, 0.3}, {0.0, 1.12, 1.12});
  CHECK_THAT(pile.front.distance, WithinAbs(2.0 + 0.5, rounding));  // 0.02 m to nothing: half a cell to 0.01 m
  CHECK(pile.front.drop == 0.0);
  CHECK(std::isnan(pile.center_of_mass.distance));
}

TEST_CASE("A threshold that no sand exceeds leaves a runout without numbers") {
  Scene scene = row_of_cells();
  scene.output.maxima->above = 5.0;
  const InitialState initial = on_a_slope();
  const RunoutReport report = RunoutMeter(scene, initial).report(initial.depth, {2.0, 2.0});
  CHECK(std::isnan(report.front.distance));
  CHECK(report.area == 0.0);
}

TEST_CASE("The largest speed is that of sand above a depth that has not drained") {
  double depth = 0.0, speed = 0.0, arrival = std::nan("");
  const auto take = [&](double h, double u, double time) {
    take_maxima(h, h, h * u, 0.0, time, 0.1, 0.25, 1e-9, depth, speed, arrival);
  };
  take(0.1, 9.0, 0.0);  // not above
  CHECK(speed == 0.0);
  CHECK(std::isnan(arrival));
  take(0.2, 1.0, 1.0);
  take(0.8, 2.0, 2.0);
  take(0.2, 9.0, 3.0);  // a quarter of the largest depth is left
  CHECK(depth == 0.8);
  CHECK(speed == 2.0);
  CHECK(arrival == 1.0);
  take(0.25, 3.0, 4.0);
  CHECK(speed == 3.0);
}

TEST_CASE("No cell of the map of speeds shows more than the fall explains") {
  Scene scene;
  scene.grid = {{40, 1}, 10.0, {0.0, 0.0}};
  scene.gravity = 9.8;
  const double slope = std::tan(42.0 * std::numbers::pi / 180.0);
  scene.terrain = {PlaneTerrain{42.0 * std::numbers::pi / 180.0}};
  scene.sand.friction_coefficient = std::tan(20.0 * std::numbers::pi / 180.0);
  SandBox box;
  box.from = {40.0, 0.0}, box.to = {120.0, 10.0};
  box.fill.depth = 1.0;
  scene.sand.initial = {box};
  scene.boundaries.x_max = BoundaryKind::open;
  scene.time.end = 20.0, scene.time.frame_interval = 1.0;
  const auto cells_above_the_bound = [&scene, slope](const MaximaOutput& maxima) {
    scene.output.maxima = maxima;
    MemorySink sink;
    run(scene, {}, sink);
    int cells = 0;
    const auto& speed = std::get<std::vector<float>>(sink.finals.max_speed);
    for (int i = 0; i < 40; ++i) {
      // From the surface of the highest release cell to the lower edge of this one.
      const double fall = std::max(0.0, 1.0 + slope * (scene.grid.x(i) + 5.0 - scene.grid.x(4)));
      cells += static_cast<double>(speed[static_cast<std::size_t>(i)]) > std::sqrt(2.0 * 9.8 * fall);
    }
    return cells;
  };
  CHECK(cells_above_the_bound({}) == 0);
  CHECK(cells_above_the_bound({0.0}) > 0);
}

TEST_CASE("A run gives the same runout with and without frames, and resumed; maxima see every step") {
  Scene scene = collapse(40, 9, Precision::float32);
  MemorySink sink;
  const RunReport whole = run(scene, {}, sink);
  REQUIRE(whole.runout);
  CHECK_THAT(whole.runout->above, WithinRel(0.002, 1e-15));
  CHECK(whole.runout->max_depth == static_cast<double>(0.2F));
  CHECK(whole.runout->front.distance > 0.2);
  CHECK_THAT(whole.runout->front.drop, WithinRel(0.2, 1e-6));  // float32

  std::atomic<bool> interrupt = false;
  std::optional<Checkpoint> kept;
  RunOptions options;
  options.interrupt = &interrupt;
  options.progress = [&](const Progress& progress) { interrupt = progress.steps >= 30; };
  options.checkpoint = [&](const Checkpoint& checkpoint) { kept = checkpoint; };
  scene.output.frames = false;
  run(scene, options, sink);
  REQUIRE(kept);
  RunOptions resume;
  resume.resume = &*kept;
  const RunReport resumed = run(scene, resume, sink);
  REQUIRE(resumed.runout);
  CHECK(resumed.runout->front.distance == whole.runout->front.distance);
  CHECK(resumed.runout->area == whole.runout->area);
  CHECK(resumed.runout->max_speed == whole.runout->max_speed);
  CHECK(resumed.runout->max_speed > 0.0);

  scene.output.maxima = MaximaOutput{0.002};
  const RunReport exact = run(scene, {}, sink);
  REQUIRE(exact.runout);
  CHECK(exact.runout->area >= whole.runout->area);
  CHECK(exact.runout->max_speed > whole.runout->max_speed);
}
