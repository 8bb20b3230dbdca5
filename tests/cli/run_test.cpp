// sandsim run, check and info, called in-process.
#include <unistd.h>

#include <algorithm>

#include "cli/machine.hpp"
#include "series_values.hpp"
#include "solver/backends/cuda/cuda.hpp"
#include "support.hpp"
#include "tests/support/catch.hpp"

using namespace sandsim::test;
namespace fs = std::filesystem;

namespace {

/// A folder with a scene, and where its results go.
struct Workplace {
  explicit Workplace(const std::string& text) { write_text(scene, text); }

  Outcome run(std::vector<std::string> more = {}) const {
    std::vector<std::string> args{"run", scene.string(), "-o", results.string()};
    args.insert(args.end(), more.begin(), more.end());
    return call(args);
  }

  TemporaryDirectory folder;
  fs::path scene = folder / "dam/scene.yaml";
  fs::path results = folder / "results";
};

/// Puts the process into a folder and back.
class WorkingDirectory {
 public:
  explicit WorkingDirectory(const fs::path& path) : before_(fs::current_path()) { fs::current_path(path); }
  ~WorkingDirectory() { fs::current_path(before_); }

 private:
  fs::path before_;
};

}  // namespace

TEST_CASE("a run writes its files and prints a summary of one screen") {
  const Workplace place(small_scene());
  const Outcome outcome = place.run();
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  CHECK(outcome.err.empty());
  for (const char* name : {"scene.resolved.yaml", "run.json", "series.h5", "series.xdmf", "log.txt"}) {
    INFO(name);
    CHECK(fs::exists(place.results / name));
  }
  CHECK_FALSE(fs::exists(place.results / "series.h5.partial"));
  CHECK_FALSE(fs::exists(place.results / "checkpoint.h5"));
  CHECK(outcome.out.starts_with("Small dam break (40 x 1 cells)\n"));
  CHECK(contains(outcome.out, "status"));
  CHECK(contains(outcome.out, "volume"));
  CHECK(contains(outcome.out, place.results.string()));
  CHECK(std::count(outcome.out.begin(), outcome.out.end(), '\n') <= 24);
}

TEST_CASE("a run goes to results and the name of the scene folder") {
  const Workplace place(small_scene());
  const WorkingDirectory here(place.folder.path());
  CHECK(call({"run", "dam", "-q"}).code == 0);
  CHECK(fs::exists(place.folder / "results/dam/series.h5"));
  fs::rename(place.scene, place.folder / "dam/other.yaml");
  CHECK(call({"run", "dam/other.yaml", "-q"}).code == 0);
  CHECK(fs::exists(place.folder / "results/other/series.h5"));
}

TEST_CASE("a quiet run prints nothing") {
  const Outcome outcome = Workplace(small_scene()).run({"-q"});
  CHECK(outcome.code == 0);
  CHECK(outcome.out.empty());
  CHECK(outcome.err.empty());
}

TEST_CASE("a verbose run says which device it took") {
  const Outcome outcome = Workplace(small_scene()).run({"-v"});
  CHECK(outcome.code == 0);
  CHECK(contains(outcome.err, "device cpu (auto: fewer than 16384 cells"));
}

TEST_CASE("the report on standard output is the one in the directory") {
  const Workplace place(small_scene());
  const Outcome outcome = place.run({"--json"});
  CHECK(outcome.code == 0);
  CHECK(outcome.out == read_text(place.results / "run.json"));
  CHECK(contains(outcome.out, "\"exit_code\": 0"));
}

TEST_CASE("the precision option overrides the scene and the set option") {
  const Workplace place(small_scene());
  CHECK(place.run({"--set", "numerics.precision=float32", "--precision", "float64"}).code == 0);
  CHECK(contains(read_text(place.results / "run.json"), "\"precision\": \"float64\""));
}

TEST_CASE("the number of threads does not change the series") {
  const Workplace place(small_scene());
  CHECK(place.run({"--threads", "1"}).code == 0);
  CHECK(call({"run", place.scene.string(), "-o", (place.folder / "two").string(), "--threads", "2"}).code == 0);
  CHECK(differing_values(place.results / "series.h5", place.folder / "two/series.h5").empty());
}

TEST_CASE("a directory that is not empty is refused unless it may be overwritten") {
  const Workplace place(small_scene());
  write_text(place.results / "notes.txt", "mine");
  const Outcome refused = place.run();
  CHECK(refused.code == 6);
  CHECK(contains(refused.err, "--overwrite"));
  CHECK_FALSE(fs::exists(place.results / "series.h5"));
  CHECK(place.run({"--overwrite"}).code == 0);
  CHECK(read_text(place.results / "notes.txt") == "mine");
}

TEST_CASE("a directory that cannot be made is an output error") {
  const Workplace place(small_scene());
  write_text(place.folder / "file", "");
  for (const std::string& directory : {std::string("/proc/sandsim"), (place.folder / "file").string()}) {
    const Outcome outcome = call({"run", place.scene.string(), "-o", directory});
    INFO(outcome.err);
    CHECK(outcome.code == 6);
    CHECK(outcome.err.starts_with("sandsim: error: "));
  }
}

TEST_CASE("a directory that is read-only is an output error") {
  if (geteuid() == 0) {
    WARN("skipped: root writes everywhere");
    return;
  }
  const Workplace place(small_scene());
  fs::create_directory(place.results);
  fs::permissions(place.results, fs::perms::owner_read | fs::perms::owner_exec);
  CHECK(place.run().code == 6);
}

TEST_CASE("an invalid scene exits 2 and writes nothing") {
  const Workplace place("grid: {cells: [40, 1], spacing: 1}\nsnad: {}\n");
  const Outcome outcome = place.run();
  INFO(outcome.err);
  CHECK(outcome.code == 2);
  CHECK(outcome.err.starts_with("sandsim: error: "));
  CHECK(contains(outcome.err, "snad"));
  CHECK_FALSE(fs::exists(place.results));
}

TEST_CASE("a failure with json is a report too") {
  const Outcome outcome = Workplace("grid: {}\n").run({"--json"});
  CHECK(outcome.code == 2);
  CHECK(contains(outcome.out, "\"exit_code\": 2"));
  CHECK(contains(outcome.out, "\"status\": \"failed\""));
}

TEST_CASE("a numerical failure exits 5 and keeps the last good frame") {
  const Workplace place(small_scene());
  const Outcome outcome =
      place.run({"--set", "time.mode=fixed", "--set", "time.step=20 ms", "--set", "time.frame_interval=20 ms"});
  INFO(outcome.err);
  CHECK(outcome.code == 5);
  CHECK(contains(outcome.err, "stability bound"));
  CHECK(contains(outcome.out, "failed"));
  CHECK(contains(read_text(place.results / "run.json"), "\"exit_code\": 5"));
  CHECK_FALSE(fs::exists(place.results / "series.h5"));
  CHECK(call({"info", place.results.string()}).code == 0);
}

TEST_CASE("a missing scene exits 3") {
  const Outcome outcome = call({"run", "/nowhere/scene.yaml"});
  CHECK(outcome.code == 3);
  CHECK(contains(outcome.err, "/nowhere/scene.yaml"));
}

TEST_CASE("a cuda run without a device exits 4 and says what is missing and what to do") {
  if (sandsim::survey_cuda().problem.empty()) {
    return;  // there is one: tests/cuda runs on it
  }
  const Outcome outcome = Workplace(small_scene()).run({"--device", "cuda"});
  CHECK(outcome.code == 4);
  CHECK(contains(outcome.err, "--device cuda: " + sandsim::survey_cuda().problem));
  CHECK(contains(outcome.err, "--device cpu"));
}

TEST_CASE("a scene that no memory holds exits 4 and says what it needs and what would fit") {
  const std::vector<std::vector<std::string>> larger{
      {"--set", "grid.cells=[200000, 200000]"},
      {"--set", "grid.cells=[2147483647, 2147483647]"},
      {"--set", "grid.cells=[46000, 46000]", "--set", "particles={spacing: 0.01 cells, layers: 3}"},
      {"--set", "particles={spacing: 0.00001 cells, layers: 50}"}};
  for (const std::vector<std::string>& settings : larger) {
    CAPTURE(settings[1]);
    const Workplace place(small_scene());
    std::vector<std::string> all{"--set", "sand.initial.0.depth=1 cm"};
    all.insert(all.end(), settings.begin(), settings.end());
    const Outcome run = place.run(all);
    CHECK(run.code == 4);
    for (const char* part : {"need about", "of memory", "of output", "are available here", "What would fit: about"}) {
      CHECK(contains(run.err, part));
    }
    CHECK_FALSE(fs::exists(place.results));
    all.insert(all.begin(), {"check", place.scene.string()});
    const Outcome check = call(all);
    CHECK(check.code == 4);
    CHECK(check.err == run.err);
    CHECK(contains(check.out, "memory "));
    CHECK(contains(check.out, "output "));
    CHECK_FALSE(contains(check.out, "valid"));
  }
}

TEST_CASE("check looks at the sizes alone of a scene that takes more than a gigabyte") {
  const Workplace place(small_scene());
  // 32 bytes a cell and three frames of three fields: 2 GB of 3e7 cells.
  const Outcome outcome = call({"check", place.scene.string(), "--set", "grid.cells=[6000, 5000]"});
  INFO(outcome.err);
  if (outcome.code == 4) {
    WARN("skipped: this machine lacks the memory");
    return;
  }
  CHECK(outcome.code == 0);
  CHECK(contains(outcome.out, "scene is valid; what it puts on its grid was not looked at"));
  CHECK_FALSE(contains(outcome.out, "steps  "));
}

TEST_CASE("a resume without a checkpoint exits 3 and leaves no directory") {
  const Workplace place(small_scene());
  const Outcome outcome = place.run({"--resume"});
  CHECK(outcome.code == 3);
  CHECK(contains(outcome.err, "checkpoint"));
  CHECK_FALSE(fs::exists(place.results));
}

TEST_CASE("a resume of a finished run says so and touches nothing") {
  const Workplace place(small_scene());
  REQUIRE(place.run().code == 0);
  const std::string log = read_text(place.results / "log.txt");
  const auto written = fs::last_write_time(place.results / "series.h5");
  const Outcome outcome = place.run({"--resume"});
  CHECK(outcome.code == 0);
  CHECK(contains(outcome.out, "finished"));
  CHECK(read_text(place.results / "log.txt") == log);
  CHECK(fs::last_write_time(place.results / "series.h5") == written);
}

TEST_CASE("a resume of a finished run of another scene is refused") {
  const Workplace place(small_scene());
  REQUIRE(place.run().code == 0);
  const Outcome outcome = place.run({"--resume", "--set", "time.end=3 s"});
  CHECK(outcome.code == 3);
  CHECK(contains(outcome.err, "another scene"));
}

TEST_CASE("check prints the resolved scene and its needs and writes nothing") {
  const Workplace place(small_scene());
  const Outcome outcome = call({"check", place.scene.string(), "--set", "numerics.order=1"});
  INFO(outcome.err);
  CHECK(outcome.code == 0);
  for (const char* part : {"order: 1", "stages", "memory", "steps", "output", "scene is valid"}) {
    INFO(part);
    CHECK(contains(outcome.out, part));
  }
  CHECK_FALSE(fs::exists(place.results));
}

TEST_CASE("check prints the bed in the corners of the grid") {
  const Workplace place(small_scene());
  // Falls by 1 m a metre along x, and stays level along y: a centre is half a cell from the corner.
  const Outcome outcome =
      call({"check", place.scene.string(), "--set", "terrain={type: plane, inclination: 45 deg, elevation: 3 m}",
            "--set", "grid={cells: [20, 10], spacing: 0.1 m, origin: [4567000 m, 200 m]}", "--set",
            "sand.initial={type: layer, depth: 1 cm}"});
  INFO(outcome.err);
  CHECK(contains(outcome.out,
                 "bed      south-west 2.95 m at (4567000.05, 200.05); south-east 1.05 m at (4567001.95, "
                 "200.05)\n         north-west 2.95 m at (4567000.05, 200.95); north-east 1.05 m at "
                 "(4567001.95, 200.95)\n"));
}

TEST_CASE("check says where objects are and how many cells see them") {
  const Workplace place(small_scene());
  // Cells of 1 cm: a box of 3.2 cm about a centre covers three of them.
  const Outcome outcome =
      call({"check", place.scene.string(), "--set",
            "objects=[{name: post, shape: {type: box, size: [3.2 cm, 1 m, 10 cm]}, position: [5.5 cm, 0 m, 2 cm]}]"});
  CHECK(outcome.code == 0);
  CHECK(outcome.out.find("object   post: x 0.039 m to 0.071 m, y -0.5 m to 0.5 m, z -0.03 m to 0.07 m, volume 0.0032 "
                         "m^3, covers 3 cells at its start") != std::string::npos);
}

TEST_CASE("the resolved scene gives the same result again") {
  const Workplace place(small_scene());
  REQUIRE(place.run().code == 0);
  const fs::path again = place.folder / "again";
  const Outcome outcome = call({"run", (place.results / "scene.resolved.yaml").string(), "-o", again.string()});
  INFO(outcome.err);
  CHECK(outcome.code == 0);
  CHECK(differing_values(place.results / "series.h5", again / "series.h5").empty());
}

TEST_CASE("info describes a result and exits 3 where there is none") {
  const Workplace place(small_scene());
  REQUIRE(place.run().code == 0);
  const Outcome outcome = call({"info", place.results.string()});
  CHECK(outcome.code == 0);
  CHECK(contains(outcome.out, "depth"));
  CHECK(call({"info", place.folder.path().string()}).code == 3);
}
