// The comparison of a run with its references: fronts, norms and notes, on numbers that can be checked by hand.
#include <cmath>

#include "solver/reference/compare.hpp"
#include "solver/reference/dam_break.hpp"
#include "solver/reference/numeric.hpp"
#include "solver/reference/piecewise_linear.hpp"
#include "tests/support/catch.hpp"

using namespace sandsim;

namespace {

/// Ten cells of 0.1 m from x = 0, no friction, a dam of 0.2 m at x = 0.5 m.
Scene dam_scene() {
  Scene scene;
  scene.grid.cells = {10, 1};
  scene.grid.spacing = 0.1;
  scene.reference.emplace();
  scene.reference->exact = DamBreakReference{0.5, 0.2};
  return scene;
}

InitialState dam_state(const Scene& scene, double friction) {
  InitialState state;
  state.depth.assign(scene.grid.cell_count(), 0.0);
  for (int i = 0; i < 5; ++i) state.depth[static_cast<std::size_t>(i)] = 0.2;
  state.friction_coefficient = {friction};
  state.hbar_scale = {1.0};
  state.hbar_cap = {1e30};
  return state;
}

const std::vector<double> ramp{0.4, 0.3, 0.2, 0.1, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};

}  // namespace

TEST_CASE("the front is where the depth between cell centres crosses the threshold") {
  const Grid grid{{10, 1}, 0.1, {0.0, 0.0}};
  CHECK_THAT(front(grid, ramp, 0.15), WithinRel(0.30, 1e-12));
  // A threshold that a cell centre meets exactly.
  CHECK_THAT(front(grid, ramp, 0.2), WithinRel(0.25, 1e-12));
  // The tip is the outer face of the last wet cell, whose centre is 0.35.
  CHECK_THAT(front(grid, ramp, 0.0), WithinRel(0.40, 1e-12));
  CHECK(std::isnan(front(grid, ramp, 0.5)));
  const std::vector<double> full(10, 1.0);
  CHECK_THAT(front(grid, full, 0.5), WithinRel(1.0, 1e-12));
}

TEST_CASE("the front of a plane is that of its farthest row") {
  const Grid grid{{5, 2}, 0.1, {1.0, 0.0}};
  const std::vector<double> depth{1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0};
  CHECK_THAT(front(grid, depth, 0.5), WithinRel(1.2, 1e-12));
}

TEST_CASE("a piecewise linear profile has exact cell averages") {
  const std::vector<double> x{0.0, 0.25, 1.0}, y{1.0, 0.5, 0.0};
  const PiecewiseLinear profile(x, y);
  // From 0.2 to 0.3: 0.6 to 0.5 over 0.05, then 0.5 to 7/15 over 0.05.
  CHECK_THAT(profile.mean(0.2, 0.3), WithinRel(0.5 * (0.55 + 0.5 * (0.5 + 7.0 / 15.0)), 1e-14));
  CHECK_THAT(profile.mean(-1.0, 0.0), WithinRel(1.0, 1e-14));
  CHECK(profile.mean(1.0, 2.0) == 0.0);
  CHECK_THAT(profile.last_crossing(0.25), WithinRel(0.625, 1e-14));
}

TEST_CASE("the exact cell averages compare with no error") {
  const Scene scene = dam_scene();
  const InitialState state = dam_state(scene, 0.0);
  const ReferenceFrame frame = reference_at(scene, state, 0.1);
  REQUIRE(frame.depth.size() == 10);
  CHECK_THAT(frame.tip, WithinRel(0.5 + 2.0 * std::sqrt(9.8 * 0.2) * 0.1, 1e-14));
  const auto reports = compare(scene, state, 0.1, frame.depth);
  REQUIRE(reports.size() == 1);
  CHECK(*reports[0].l1 == 0.0);
  CHECK(*reports[0].linf == 0.0);
  REQUIRE(reports[0].fronts.size() == 1);
  CHECK_THAT(*reports[0].fronts[0].reference, WithinRel(frame.tip, 1e-14));
}

TEST_CASE("norms are sums over cells times the spacing") {
  Scene scene = dam_scene();
  scene.reference->exact.reset();
  scene.reference->profile = Profile{"flat.csv", {0.0, 1.0}, {0.2, 0.2}};
  scene.reference->front_depths = {0.15};
  std::vector<double> depth(10, 0.2);
  depth[3] = 0.5;
  depth[7] = 0.1;
  const auto reports = compare(scene, dam_state(scene, 0.0), 1.0, depth);
  REQUIRE(reports.size() == 1);
  CHECK(reports[0].against == "profile flat.csv");
  CHECK_THAT(*reports[0].l1, WithinRel(0.04, 1e-12));
  CHECK_THAT(*reports[0].l2, WithinRel(0.1, 1e-12));
  CHECK_THAT(*reports[0].linf, WithinRel(0.3, 1e-12));
  CHECK_THAT(*reports[0].l1_relative, WithinRel(0.2, 1e-12));
}

TEST_CASE("with friction only the tip of a dam break is compared") {
  Scene scene = dam_scene();
  scene.reference->front_depths = {0.05};
  const InitialState state = dam_state(scene, 2.0);
  const auto reports = compare(scene, state, 60.0, state.depth);
  REQUIRE(reports.size() == 1);
  CHECK_FALSE(reports[0].l1);
  CHECK(reports[0].note.find("only the tip is known") != std::string::npos);
  REQUIRE(reports[0].fronts.size() == 2);
  CHECK(reports[0].fronts[0].depth == 0.0);
  CHECK_THAT(*reports[0].fronts[0].reference, WithinRel(0.7, 1e-12));
  CHECK_FALSE(reports[0].fronts[1].reference);
  CHECK(reference_at(scene, state, 60.0).depth.empty());
}

TEST_CASE("the slope and the friction of a dam break come from the scene") {
  Scene scene = dam_scene();
  scene.boundaries.x_max = BoundaryKind::open;
  InitialState state = dam_state(scene, 0.1);
  for (int i = 0; i < 10; ++i) state.bed.push_back(5.0 - 0.3 * scene.grid.x(i));
  const DamBreak exact(0.5, 0.2, 9.8, 9.8 * (0.3 - 0.1));
  const ReferenceFrame frame = reference_at(scene, state, 0.1);
  CHECK_THAT(frame.tip, WithinRel(exact.tip(0.1), 1e-9));
  // The wall at x = 0 is felt up to 0.15 m: cells below are unknown.
  REQUIRE(frame.depth.size() == 10);
  CHECK(std::isnan(frame.depth[0]));
  CHECK_THAT(frame.depth[5], WithinRel(cell_average([&](double x) { return exact.depth(x, 0.1); }, 0.5, 0.1), 1e-9));
  CHECK(compare(scene, state, 0.1, state.depth)[0].note.find("no wall has been felt") != std::string::npos);
}

TEST_CASE("a reference that does not apply says why") {
  Scene scene = dam_scene();
  InitialState state = dam_state(scene, 0.0);
  state.depth[0] = 0.1;
  CHECK(compare(scene, state, 0.1, state.depth)[0].note.find("not that of the reference") != std::string::npos);
  state = dam_state(scene, 0.0);
  state.hbar_cap = {0.1};
  CHECK(compare(scene, state, 0.1, state.depth)[0].note.find("two-layer") != std::string::npos);
  state.hbar_cap = {1e30};
  CHECK(compare(scene, state, 9.0, state.depth)[0].note.find("end of the grid") != std::string::npos);
  state.bed = ramp;
  CHECK(compare(scene, state, 0.1, state.depth)[0].note.find("not a plane") != std::string::npos);
  CHECK(std::isnan(reference_at(scene, state, 0.1).tip));
}

TEST_CASE("a measured file that is missing is named and not replaced by anything") {
  Scene scene = dam_scene();
  scene.reference->exact.reset();
  scene.reference->measured_profile = Profile{"hungr.csv", {}, {}};
  scene.reference->measured_front = FrontCurve{"fronts.csv", {}, {}};
  const auto reports = compare(scene, dam_state(scene, 0.0), 1.0, ramp);
  REQUIRE(reports.size() == 2);
  CHECK(reports[0].against == "measured profile hungr.csv");
  CHECK(reports[0].note.find("missing") != std::string::npos);
  CHECK_FALSE(reports[0].l1);
  CHECK(reports[1].against == "measured front fronts.csv");
  CHECK(reports[1].note.find("missing") != std::string::npos);
}

TEST_CASE("a measured front is interpolated in time") {
  Scene scene = dam_scene();
  scene.reference->exact.reset();
  scene.reference->front_depths = {0.05};
  scene.reference->measured_front = FrontCurve{"fronts.csv", {0.0, 1.0}, {0.4, 0.6}};
  const auto inside = compare(scene, dam_state(scene, 0.0), 0.25, ramp);
  CHECK_THAT(*inside[0].fronts[0].reference, WithinRel(0.45, 1e-12));
  CHECK_FALSE(compare(scene, dam_state(scene, 0.0), 2.0, ramp)[0].fronts[0].reference);
}

TEST_CASE("a scene without references reports the fronts alone") {
  Scene scene = dam_scene();
  scene.reference->exact.reset();
  CHECK(compare(scene, dam_state(scene, 0.0), 1.0, ramp).empty());
  scene.reference->front_depths = {0.15};
  const auto reports = compare(scene, dam_state(scene, 0.0), 1.0, ramp);
  REQUIRE(reports.size() == 1);
  CHECK_THAT(reports[0].fronts[0].computed, WithinRel(0.3, 1e-12));
  scene.reference.reset();
  CHECK(compare(scene, dam_state(scene, 0.0), 1.0, ramp).empty());
}
