#include "io/scene/overrides.hpp"

#include "tests/scene/support.hpp"
#include "tests/support/catch.hpp"

using namespace sandsim;
using namespace sandsim::test;

TEST_CASE("an override replaces a value of the file") {
  const Scene s = read(smallest_scene, {"time.end=5s", "grid.cells.0=40", "numerics.scheme=paper"});
  CHECK(s.time.end == 5.0);
  CHECK(s.grid.cells[0] == 40);
  CHECK(s.numerics.scheme == Scheme::paper);
}

TEST_CASE("an override may be a map or a list") {
  const Scene s = read(smallest_scene, {"sand.hbar={policy: truncated, scale: 0.8, cap: 5 cm}", "grid.cells=[30, 1]"});
  CHECK(std::get<double>(s.sand.hbar.cap) == 0.05);
  CHECK(s.grid.cells[0] == 30);
}

TEST_CASE("overrides count entries of lists and append to them") {
  const std::string text = smallest_scene + "output: {probes: [{name: a, at: [1 cm, 0 m]}]}\n";
  const Scene s = read(text, {"output.probes.1={name: b, at: [2 cm, 0 m]}", "output.probes.0.name=c"});
  REQUIRE(s.output.probes.size() == 2);
  CHECK(s.output.probes[0].name == "c");
  CHECK(s.output.probes[1].at[0] == 0.02);
}

TEST_CASE("index 0 is also the only entry that stands for a list") {
  for (const char* override : {"sand.initial.0.depth=30cm", "sand.initial.depth=30cm"}) {
    const Scene s = read(smallest_scene, {override});
    CHECK(std::get<SandLayer>(s.sand.initial.at(0)).fill.depth == 0.3);
  }
}

TEST_CASE("an override without a value removes the key") {
  const Scene s = read(smallest_scene, {"sand.friction_angle=", "sand.friction_coefficient=0.5"});
  CHECK_FALSE(s.sand.friction_angle);
  CHECK(std::get<double>(*s.sand.friction_coefficient) == 0.5);
}

TEST_CASE("later overrides win") {
  CHECK(read(smallest_scene, {"time.end=5 s", "time.end=6 s"}).time.end == 6.0);
}

TEST_CASE("a wrong value of an override is reported as such") {
  CHECK(complaints(smallest_scene, {"time.end=5"}) ==
        "--set time.end=5: time.end = 5: a time needs a unit (no unit is assumed). Did you mean \"5 s\"?");
  CHECK(complaints(smallest_scene, {"time.frame_interval=2 s"}) ==
        "--set time.frame_interval=2 s: time.frame_interval = 2 s: longer than the run (time.end is 1 s). "
        "Use at most \"1 s\".");
}

TEST_CASE("overrides that name nothing are errors") {
  CHECK(complaints(smallest_scene, {"time"}) ==
        "--set time: not of the form key.path=value. Write it like --set time.end=5s.");
  CHECK(complaints(smallest_scene, {"=3"}) ==
        "--set =3: not of the form key.path=value. Write it like --set time.end=5s.");
  CHECK(complaints(smallest_scene, {"grid.cells.7=3"}) ==
        "--set grid.cells.7=3: no entry 7 (the list has 2, counted from 0).");
  CHECK(complaints(smallest_scene, {"grid.cells.x=3"}) ==
        "--set grid.cells.x=3: 'x' is no index (it counts the 2 entries of a list from 0).");
  CHECK(complaints(smallest_scene, {"time.end.x=3"}) ==
        "--set time.end.x=3: 'x' lies inside a value ('1 s' is no map).");
  CHECK(complaints(smallest_scene, {"gravity="}) ==
        "--set gravity=: nothing to remove (the scene does not give this key).");
  CHECK(complaints(smallest_scene, {"title=a: b: c"}) ==
        "--set title=a: b: c: not valid YAML (illegal map value). Put text with special characters in quotes.");
}
