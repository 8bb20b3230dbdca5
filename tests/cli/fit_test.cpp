// `sandsim fit`: what it finds, what it says it cannot find, and what it says about bad input.
#include <signal.h>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "support.hpp"
#include "tests/support/catch.hpp"

using namespace sandsim::test;
namespace fs = std::filesystem;

namespace {

/// A dam break with hbar = min(0.7 h, 2 cm), of which a run takes a millisecond.
std::string layered_scene() {
  return R"(title: Dam break to fit
grid: {cells: [60, 1], spacing: 1 cm}
sand:
  friction_angle: 25 deg
  hbar: {policy: truncated, scale: 0.7, cap: 2 cm}
  initial: {type: box, from: [0 m, 0 m], to: [20 cm, 1 cm], depth: 10 cm}
time: {end: 1 s, frame_interval: 20 ms, stop_at_rest: true}
)";
}

struct Workplace {
  Workplace() { write_text(scene, layered_scene()); }

  /// A run of the scene that the fit is to find again.
  void make_truth(const std::vector<std::string>& settings = {}) const {
    std::vector<std::string> args{"run", scene.string(), "-q", "-o", truth.string()};
    for (const std::string& setting : settings) {
      args.insert(args.end(), {"--set", setting});
    }
    REQUIRE(call(args).code == 0);
  }
  Outcome fit(const std::vector<std::string>& more) const {
    std::vector<std::string> args{"fit", scene.string(), "-o", results.string()};
    args.insert(args.end(), more.begin(), more.end());
    return call(args);
  }
  std::string report() const { return read_text(results / "fit.yaml"); }
  /// The first number behind `key` after the parameter is named, in fit.yaml; of the fit itself for no parameter.
  double number(const std::string& parameter, const std::string& key) const {
    const std::string text = report();
    const std::size_t at = text.find(key + ": ", parameter.empty() ? 0 : text.find("- key: " + parameter));
    REQUIRE(at != std::string::npos);
    return std::stod(text.substr(at + key.size() + 2));
  }
  std::vector<std::string> lines(const std::string& file) const {
    std::vector<std::string> all;
    std::istringstream text(read_text(results / file));
    for (std::string line; std::getline(text, line);) {
      all.push_back(line);
    }
    return all;
  }

  TemporaryDirectory folder;
  fs::path scene = folder / "scene.yaml";
  fs::path truth = folder / "truth";
  fs::path results = folder / "results";
};

const std::vector<std::string> scale_and_cap{"--vary", "sand.hbar.scale=0.3:1", "--vary", "sand.hbar.cap=0.5:10 cm"};

std::vector<std::string> with(std::vector<std::string> first, const std::vector<std::string>& more) {
  first.insert(first.end(), more.begin(), more.end());
  return first;
}

}  // namespace

TEST_CASE("a fit finds scale and cap from the front of a run") {
  const Workplace place;
  place.make_truth();
  const Outcome outcome = place.fit(with(scale_and_cap, {"--run", place.truth.string(), "--front-depth", "3 mm"}));
  INFO(outcome.err << outcome.out);
  REQUIRE(outcome.code == 0);
  // 2 % is what a fit has to reach; the misfit is that of the front of the same run but for rounding.
  CHECK(std::abs(place.number("sand.hbar.scale", "best") / 0.7 - 1.0) < 0.02);
  CHECK(std::abs(place.number("sand.hbar.cap", "best") / 2.0 - 1.0) < 0.02);
  CHECK(place.number("", "misfit") < 1e-4);
  CHECK(contains(place.report(), "data_tell: known"));
  // The range holds the best value and is no wider than the bounds.
  const std::size_t range = place.report().find("from: ", place.report().find("fits_equally_well"));
  CHECK(std::stod(place.report().substr(range + 6)) <= place.number("sand.hbar.scale", "best"));
  CHECK(place.lines("map.csv").size() == 1 + 11 * 11);
  CHECK(place.lines("fit.csv").front().starts_with("run,stage,sand.hbar.scale,sand.hbar.cap [cm],misfit [m]"));
}

TEST_CASE("a fit does not depend on how many runs go side by side") {
  const Workplace place;
  place.make_truth();
  const auto values = [&](const char* jobs) {
    const std::vector<std::string> options{"--run", place.truth.string(), "-j", jobs, "--evaluations", "30",
                                           "-q",    "--overwrite"};
    REQUIRE(place.fit(with(scale_and_cap, options)).code == 0);
    std::vector<std::string> lines = place.lines("fit.csv");
    for (std::string& line : lines) {
      line.erase(line.rfind(','));  // the wall time
    }
    return lines;
  };
  const std::vector<std::string> alone = values("1");
  CHECK(alone.size() > 100);
  CHECK(values("3") == alone);
}

TEST_CASE("a fit finds the friction angle from a deposit") {
  const Workplace place;
  place.make_truth();  // at rest long before 0.9 s
  const Outcome outcome =
      place.fit({"--vary", "sand.friction_angle=15:40 deg", "--run", place.truth.string(), "--at", "0.9 s"});
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  CHECK(std::abs(place.number("sand.friction_angle", "best") - 25.0) < 0.5);
  CHECK(contains(outcome.out, "profile of 60 points"));
  CHECK(place.lines("map.csv").size() == 1 + 33);
}

TEST_CASE("a fit says so when the data do not tell a value") {
  const Workplace place;
  // hbar = 0.7 h is at most 7 cm: no cap above that has any effect.
  place.make_truth({"sand.hbar.cap=9 cm"});
  const Outcome outcome = place.fit(
      {"--vary", "sand.hbar.scale=0.3:1", "--vary", "sand.hbar.cap=10.5:40 cm", "--run", place.truth.string()});
  INFO(outcome.out);
  REQUIRE(outcome.code == 0);
  CHECK(contains(outcome.out, "The data do not tell sand.hbar.cap: any value between 10.5 cm and 40 cm fits within"));
  CHECK(contains(place.report(), "data_tell: nothing"));
  CHECK(std::abs(place.number("sand.hbar.scale", "best") / 0.7 - 1.0) < 0.02);
}

TEST_CASE("a fit says so when the best value is a bound") {
  const Workplace place;
  place.make_truth();
  const Outcome outcome = place.fit({"--vary", "sand.hbar.cap=0.5:1.2 cm", "--run", place.truth.string()});
  REQUIRE(outcome.code == 0);
  CHECK(contains(outcome.out, "The best sand.hbar.cap is its bound, 1.2 cm: the optimum may lie beyond"));
  CHECK(contains(outcome.out, "The scene does not give the data"));
}

TEST_CASE("runs that fail count as a large misfit and are listed") {
  const Workplace place;
  place.make_truth({"sand.initial.depth=8 cm"});
  // Thinner than the front's depth there is no front.
  const Outcome outcome =
      place.fit({"--vary", "sand.initial.depth=0.1:12 cm", "--run", place.truth.string(), "--front-depth", "2 cm"});
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  CHECK(std::abs(place.number("sand.initial.depth", "best") / 8.0 - 1.0) < 0.02);
  CHECK(contains(outcome.out, "runs failed and count as a large misfit (see fit.csv); the first: no sand is deeper"));
  CHECK(contains(read_text(place.results / "fit.csv"), "there is no front"));
}

TEST_CASE("a front is read from CSV and points beyond the run are left out") {
  const Workplace place;
  const fs::path file = place.folder / "front.csv";
  write_text(file, "time_s,front_m\n0.1,0.27\n0.2,0.32\n5,0.4\n");
  const std::vector<std::string> options{"--vary", "sand.hbar.cap=1:4 cm", "--front", file.string()};
  const Outcome outcome = place.fit(options);
  REQUIRE(outcome.code == 0);
  CHECK(contains(outcome.err, "1 of 3 points are left out: they lie outside of the scene's time, 0 to 1 s"));
  CHECK(contains(outcome.out, "front of 2 points"));
  const Outcome again = place.fit(options);
  CHECK(again.code == 6);
  CHECK(contains(again.err, "is not empty"));
}

TEST_CASE("a fit takes the references that the scene names") {
  const Workplace place;
  // Stoker's dam break, whose profile is known: gravity sets its pace.
  write_text(place.scene, R"(grid: {cells: [200, 1], spacing: 1 cm}
gravity: 9.8 m/s^2
sand:
  friction_angle: 0 deg
  initial:
    - {type: box, from: [0 m, 0 m], to: [1 m, 1 cm], depth: 8 cm}
    - {type: layer, depth: 2 cm}
time: {end: 0.5 s, frame_interval: 50 ms}
reference:
  exact: {type: stoker, dam: 1 m, depth: 10 cm, downstream_depth: 2 cm}
)");
  const std::vector<std::string> gravity{"--vary", "gravity=5:15 m/s^2", "--overwrite"};
  const Outcome front = place.fit(with(gravity, {"--front-depth", "4 cm"}));
  INFO(front.err);
  REQUIRE(front.code == 0);
  CHECK(contains(front.out, "front of 10 points from the scene's exact solution"));
  // The shock runs with the root of gravity over some 60 cells and is known to a fraction of one: 5 % of gravity.
  CHECK(std::abs(place.number("gravity", "best") / 9.8 - 1.0) < 0.05);
  const Outcome profile = place.fit(with(gravity, {"--at", "0.4 s"}));
  INFO(profile.err);
  REQUIRE(profile.code == 0);
  CHECK(contains(profile.out, "from the scene's exact solution at 0.4 s"));
  CHECK(std::abs(place.number("gravity", "best") / 9.8 - 1.0) < 0.05);
}

TEST_CASE("bad input of a fit is named") {
  const Workplace place;
  const fs::path late = place.folder / "late.csv", bad = place.folder / "bad.csv", away = place.folder / "away.csv";
  write_text(late, "time_s,front_m\n10,0.3\n20,0.4\n");
  write_text(bad, "time_s,front_m\n0.1,0.3\n0.2,far\n");
  write_text(away, "x_m,depth_m\n10,0.3\n20,0.4\n");
  struct Case {
    std::vector<std::string> arguments;
    int code;
    std::string message;
  };
  const std::string cap = "sand.hbar.cap=1:4 cm";
  const std::vector<Case> cases{
      {{"--front", late}, 1, "nothing varies"},
      {{"--vary", "sand.hbr.cap=1:4 cm", "--front", late}, 2, "Did you mean 'hbar'"},
      {{"--vary", "sand.hbar.scale=0.3:1.5", "--front", late},
       2,
       "--vary sand.hbar.scale=1.5: sand.hbar.scale = 1.5: "},
      {{"--vary", "sand.hbar.scale=1:0.3", "--front", late}, 1, "reversed. Write sand.hbar.scale=0.3:1."},
      {{"--vary", "sand.hbar.scale=1:1", "--front", late}, 1, "first and its last value are the same"},
      {{"--vary", "sand.hbar.scale=0.5", "--front", late}, 1, "no interval"},
      {{"--vary", "sand.hbar.cap=1 cm:40 mm", "--front", late}, 1, "mixed units"},
      {{"--vary", "sand.hbar.cap=1:4", "--front", late}, 2, "needs a unit"},
      {{"--vary", cap, "--vary", cap, "--front", late}, 1, "varies twice"},
      {{"--vary", cap, "--set", "sand.hbar.cap=2 cm", "--front", late}, 1, "both set and varied"},
      {{"--vary", cap, "--front", late}, 3, "10 to 20 s, do not overlap with the scene's time, 0 to 1 s"},
      {{"--vary", cap, "--front", bad}, 3, "bad.csv:3:5: front_m: \"far\" is not a number"},
      {{"--vary", cap, "--profile", away}, 3, "10 to 20 m, do not overlap with the grid, 0 to 0.6 m"},
      {{"--vary", cap, "--profile", away, "--at", "3 s"}, 3, "3 s is after the end of the scene, 1 s"},
      {{"--vary", cap, "--profile", away, "--at", "3"}, 1, "--at 3: "},
      {{"--vary", cap, "--run", place.folder / "nothing"}, 3, "no such folder of results"},
      {{"--vary", cap}, 2, "names no reference"},
      {{"--vary", cap, "--front", late, "--profile", away}, 1, "excludes"},
  };
  for (const Case& one : cases) {
    const Outcome outcome = place.fit(one.arguments);
    INFO(one.message << "\n" << outcome.err);
    CHECK(outcome.code == one.code);
    CHECK(contains(outcome.err, one.message));
    CHECK_FALSE(fs::exists(place.results));
  }
}

TEST_CASE("a fit of more than a thousand runs has to be meant") {
  const Workplace place;
  place.make_truth();
  const Outcome outcome =
      place.fit({"--vary", "sand.hbar.scale=0.3:1", "--run", place.truth.string(), "--evaluations", "2000"});
  CHECK(outcome.code == 1);
  CHECK(contains(outcome.err, "if that is meant, say --yes"));
}

TEST_CASE("a fit that is interrupted keeps its runs") {
  const TemporaryDirectory folder;
  const fs::path scene = folder / "scene.yaml", front = folder / "front.csv", results = folder / "results";
  write_text(scene, endless_scene());
  write_text(front, "time_s,front_m\n0.1,0.3\n1000,0.4\n");
  Process process({"fit", scene.string(), "--vary", "sand.friction_angle=20:30 deg", "--front", front.string(), "-o",
                   results.string()},
                  folder.path());
  REQUIRE(wait_until([&] { return fs::exists(results); }));
  process.send(SIGTERM);
  const Outcome outcome = process.wait();
  INFO(outcome.err);
  CHECK(outcome.code == 130);
  CHECK(contains(outcome.err, "interrupted by SIGTERM"));
  CHECK(read_text(results / "fit.csv").starts_with("run,stage,sand.friction_angle [deg]"));
  CHECK_FALSE(fs::exists(results / "fit.yaml"));
}
