#include "solver/checks.hpp"

#include "tests/scene/support.hpp"
#include "tests/support/catch.hpp"

using namespace sandsim;
using namespace sandsim::test;

TEST_CASE("a scene that can be run has no issues") {
  CHECK(check(read(smallest_scene)).empty());
}

TEST_CASE("issues name the key to change and the keys they rest on") {
  Scene scene = read(smallest_scene);
  scene.sand.friction_coefficient = 0.5;
  const std::vector<Issue> issues = check(scene);
  REQUIRE(issues.size() == 1);
  CHECK(issues[0].key == "sand.friction_coefficient");
  CHECK(issues[0].uses == std::vector<std::string>{"sand.friction_angle"});
}

TEST_CASE("with one row only x decides whether sand lies on the grid") {
  CHECK(complaints(smallest_scene, {"sand.initial={type: cone, center: [5 cm, 9 m], radius: 1 cm, height: 1 cm}"})
            .empty());
  CHECK_FALSE(complaints(smallest_scene, {"grid.cells.1=2",
                                          "sand.initial={type: cone, center: [5 cm, 9 m], radius: 1 cm, height: 1 cm}"})
                  .empty());
}

TEST_CASE("a frame interval of a whole number of steps is found in spite of rounding") {
  // 0.3 / 0.1 and 0.07 / 0.01 are not whole numbers in double precision.
  CHECK(complaints(smallest_scene, {"time={mode: fixed, step: 0.1 s, end: 1 s, frame_interval: 0.3 s}"}).empty());
  CHECK(complaints(smallest_scene, {"time={mode: fixed, step: 10 ms, end: 1 s, frame_interval: 0.07 s}"}).empty());
}

TEST_CASE("a step longer than a frame is rejected") {
  CHECK_FALSE(complaints(smallest_scene, {"time={mode: fixed, step: 0.4 s, end: 1 s, frame_interval: 0.3 s}"}).empty());
}
