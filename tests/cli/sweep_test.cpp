// Sweeps from the command line: what runs, what is kept, what goes on after an end.
#include <signal.h>
#include <sys/resource.h>

#include <algorithm>
#include <sstream>

#include "series_values.hpp"
#include "support.hpp"
#include "tests/support/catch.hpp"

using namespace sandsim::test;
namespace fs = std::filesystem;

namespace {

using Row = std::vector<std::string>;

/// A small scene and a folder for its sweep.
struct Workplace {
  explicit Workplace(const std::string& text = small_scene()) { write_text(scene, text); }

  std::vector<std::string> arguments(const std::vector<std::string>& more) const {
    std::vector<std::string> args{"sweep", scene.string(), "-o", results.string()};
    args.insert(args.end(), more.begin(), more.end());
    return args;
  }
  /// A process, since a sweep starts its cases from its own executable.
  Outcome sweep(const std::vector<std::string>& more) const { return Process(arguments(more), folder.path()).wait(); }

  /// The lines of summary.csv, split at commas: the tests have no quoted fields.
  std::vector<Row> table() const {
    std::vector<Row> rows;
    std::istringstream lines(read_text(results / "summary.csv"));
    for (std::string line; std::getline(lines, line);) {
      Row row;
      std::istringstream fields(line);
      for (std::string field; std::getline(fields, field, ',');) {
        row.push_back(field);
      }
      rows.push_back(row);
    }
    return rows;
  }
  std::string value(std::size_t number, const std::string& column) const {
    const std::vector<Row> rows = table();
    const auto found = std::find(rows.at(0).begin(), rows.at(0).end(), column);
    REQUIRE(found != rows.at(0).end());
    return rows.at(number).at(static_cast<std::size_t>(found - rows[0].begin()));
  }
  fs::path case_folder(std::size_t number) const { return results / value(number, "folder"); }

  TemporaryDirectory folder;
  fs::path scene = folder / "scene.yaml";
  fs::path results = folder / "results";
};

/// Folders in which a run has been finished.
std::vector<fs::path> finished_cases(const fs::path& results) {
  std::vector<fs::path> found;
  std::error_code not_there;
  for (const fs::directory_entry& entry : fs::directory_iterator(results / "cases", not_there)) {
    if (contains(read_text(entry.path() / "run.json"), "\"exit_code\": 0")) {
      found.push_back(entry.path());
    }
  }
  return found;
}

}  // namespace

TEST_CASE("a sweep has the bits of single runs and is not run twice") {
  const Workplace place;
  const std::vector<std::string> vary{
      "--vary", "sand.friction_angle=20:30:2 deg", "--vary", "sand.hbar.policy=full", "-j", "2"};
  const Outcome outcome = place.sweep(vary);
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  CHECK(contains(outcome.out, "2 of 2 done"));
  CHECK(contains(outcome.err, "case 2 of 2: at rest"));
  CHECK(place.value(2, "sand.friction_angle [deg]") == "30");
  CHECK(place.value(2, "status") == "at rest");
  const fs::path single = place.folder / "single";
  REQUIRE(
      call({"run", place.scene.string(), "-q", "-o", single.string(), "--set", "sand.friction_angle=30 deg"}).code ==
      0);
  CHECK(differing_values(place.case_folder(2) / "series.h5", single / "series.h5").empty());
  CHECK_FALSE(differing_values(place.case_folder(1) / "series.h5", single / "series.h5").empty());

  const fs::file_time_type before = fs::last_write_time(place.case_folder(1) / "run.json");
  CHECK(contains(place.sweep(vary).err, "2 of 2 cases are done already"));
  CHECK(Process({"sweep", place.results.string()}, place.folder.path()).wait().code == 0);
  CHECK(fs::last_write_time(place.case_folder(1) / "run.json") == before);
  // More values are more cases; those that are there are kept.
  const Outcome more = place.sweep({"--vary", "sand.friction_angle=20:30:3 deg", "--vary", "sand.hbar.policy=full"});
  CHECK(contains(more.err, "2 of 3 cases are done already"));
  CHECK(fs::last_write_time(place.case_folder(1) / "run.json") == before);
}

TEST_CASE("a sweep that is killed resumes without running a finished case again") {
  const Workplace place(long_scene());
  const std::vector<std::string> vary{"--vary", "sand.friction_angle=22:31:4 deg", "-j", "1"};
  Process process(place.arguments(vary), place.folder.path());
  const auto partial_there = [&] {
    for (const fs::directory_entry& entry : fs::directory_iterator(place.results / "cases")) {
      if (fs::exists(entry.path() / "series.h5.partial")) {
        return true;
      }
    }
    return false;
  };
  REQUIRE(wait_until([&] { return !finished_cases(place.results).empty() && partial_there(); }));
  process.send(SIGKILL);
  CHECK(process.wait().code == 128 + SIGKILL);
  const std::vector<fs::path> finished = finished_cases(place.results);
  REQUIRE(finished.size() < 4);
  std::vector<std::string> reports;
  for (const fs::path& folder : finished) {
    reports.push_back(read_text(folder / "run.json"));
  }

  const Outcome outcome = place.sweep(vary);
  INFO(outcome.err);
  CHECK(outcome.code == 0);
  for (std::size_t k = 0; k < finished.size(); ++k) {
    CHECK(read_text(finished[k] / "run.json") == reports[k]);
  }
  CHECK(finished_cases(place.results).size() == 4);
  const fs::path single = place.folder / "single";
  std::vector<std::string> resumed;
  for (std::size_t number = 1; number <= 4; ++number) {
    const fs::path folder = place.case_folder(number);
    if (!contains(read_text(folder / "log.txt"), "going on from")) {
      continue;
    }
    resumed.push_back(folder.string());
    const std::string angle = "sand.friction_angle=" + place.value(number, "sand.friction_angle [deg]") + " deg";
    REQUIRE(call({"run", place.scene.string(), "-q", "--overwrite", "-o", single.string(), "--set", angle}).code == 0);
    CHECK(differing_values(folder / "series.h5", single / "series.h5").empty());
  }
  // The case that ran when its parent was killed got a signal of its own, and wrote its checkpoint.
  CHECK(resumed.size() == 1);
}

TEST_CASE("a sweep that is interrupted exits 130 and goes on") {
  const Workplace place(endless_scene());
  Process process(place.arguments({"--vary", "gravity=9,10 m/s^2", "-j", "1"}), place.folder.path());
  REQUIRE(wait_until([&] {
    std::error_code not_there;
    for (const auto& entry : fs::directory_iterator(place.results / "cases", not_there)) {
      if (fs::exists(entry.path() / "series.h5.partial")) {
        return true;
      }
    }
    return false;
  }));
  process.send(SIGINT);
  const Outcome outcome = process.wait();
  INFO(outcome.err);
  CHECK(outcome.code == 130);
  CHECK(contains(outcome.err, "interrupted by SIGINT"));
  CHECK(contains(outcome.out, "0 of 2 done, 1 interrupted, 1 not run"));
  CHECK(place.value(1, "status") == "interrupted");
  CHECK(fs::exists(place.case_folder(1) / "checkpoint.h5"));
  const Outcome limited = place.sweep({"--vary", "gravity=9,10 m/s^2", "-j", "2", "--max-wall", "00:00:01"});
  CHECK(limited.code == 7);
  CHECK(contains(limited.err, "--max-wall reached"));
  CHECK(contains(read_text(place.case_folder(1) / "log.txt"), "going on from"));
}

TEST_CASE("a case that fails is recorded and the others go on") {
  const Workplace place;
  const std::vector<std::string> vary{"--vary", "sand.friction_angle=20,95,30 deg"};
  const Outcome refused = place.sweep(vary);
  CHECK(refused.code == 2);
  CHECK(contains(refused.err, "--vary sand.friction_angle=95 deg: "));
  CHECK(contains(refused.err, "1 of 3 cases are invalid; nothing was run"));
  CHECK_FALSE(fs::exists(place.results));
  const Outcome outcome = place.sweep({vary[0], vary[1], "--skip-invalid"});
  CHECK(outcome.code == 2);
  CHECK(contains(outcome.out, "2 of 3 done, 1 failed"));
  CHECK(place.value(2, "exit_code") == "2");
  CHECK(place.value(3, "exit_code") == "0");
}

TEST_CASE("a full disk fails a case with exit code 6, and it is tried again") {
  const Workplace place;
  const auto limit = [] {
    const rlimit bytes{3'000'000, 3'000'000};
    setrlimit(RLIMIT_FSIZE, &bytes);
  };
  // The second case keeps so many frames that they do not fit.
  const std::vector<std::string> vary{"--vary", "time.frame_interval=20,0.2,10 ms", "--set", "grid.cells=[400, 1]"};
  const Outcome full = Process(place.arguments(vary), place.folder.path(), limit).wait();
  INFO(full.err);
  CHECK(full.code == 6);
  CHECK(contains(full.out, "2 of 3 done, 1 failed"));
  CHECK(place.value(2, "exit_code") == "6");
  CHECK(place.value(3, "exit_code") == "0");
  const Outcome again = place.sweep(vary);
  CHECK(again.code == 0);
  CHECK(contains(again.err, "2 of 3 cases are done already"));
}

TEST_CASE("a directory that holds something else is refused and left alone") {
  const Workplace place;
  REQUIRE(place.sweep({"--vary", "gravity=9,10 m/s^2"}).code == 0);
  const fs::path kept = place.case_folder(1);
  write_text(kept / "notes.txt", "mine");
  const std::vector<std::string> other{"--vary", "gravity=1,2 m/s^2"};
  const Outcome refused = place.sweep(other);
  CHECK(refused.code == 6);
  CHECK(contains(refused.err, "holds another sweep"));
  CHECK(fs::exists(kept / "series.h5"));
  REQUIRE(place.sweep({other[0], other[1], "--overwrite"}).code == 0);
  CHECK_FALSE(fs::exists(kept / "series.h5"));
  CHECK(read_text(kept / "notes.txt") == "mine");
  CHECK(finished_cases(place.results).size() == 2);

  // What a sweep that could not even write what it is has left is no obstacle.
  write_text(place.folder / "begun" / "sweep.lock", "");
  CHECK(call({"sweep", place.scene.string(), "-o", (place.folder / "begun").string(), "--vary", "gravity=9,10 m/s^2",
              "--expand"})
            .code == 0);
  write_text(place.folder / "mine" / "thesis.txt", "chapter 1");
  const Outcome mine = call({"sweep", place.scene.string(), "-o", (place.folder / "mine").string(), "--vary",
                             "gravity=9,10 m/s^2", "--overwrite"});
  CHECK(mine.code == 6);
  CHECK(contains(mine.err, "holds no sweep"));
}

TEST_CASE("cases are expanded, run one by one and collected") {
  const Workplace place;
  const Outcome expanded = place.sweep({"--vary", "gravity=9,10 m/s^2", "--expand"});
  CHECK(expanded.code == 0);
  CHECK(contains(read_text(place.results / "sweep.sbatch"), "#SBATCH --array=1-2\n"));
  const std::string results = place.results.string();
  CHECK(call({"sweep", results, "--collect"}).code == 3);
  CHECK(place.value(1, "status") == "not run");
  for (const char* number : {"1", "2"}) {
    const Outcome one = call({"sweep", results, "--case", number});
    INFO(one.err);
    CHECK(one.code == 0);
    CHECK(contains(one.out, "Small dam break"));
  }
  CHECK(contains(call({"sweep", results, "--case", "2"}).out, "case 2 is done already"));
  CHECK(call({"sweep", results, "--case", "3"}).code == 1);
  const Outcome collected = call({"sweep", results, "--collect"});
  CHECK(collected.code == 0);
  CHECK(contains(collected.out, "2 of 2 done"));
  CHECK(contains(call({"sweep", results, "--list"}).out, "at rest  gravity=10 m/s^2"));
  // A scene that changes under a sweep is not mixed with what it was.
  write_text(place.scene, small_scene() + "title2: x\n");
  fs::remove_all(place.case_folder(1));
  CHECK(call({"sweep", results, "--case", "1"}).code == 3);
}

TEST_CASE("files that a case reads are part of it") {
  const Workplace place(R"(grid: {cells: [10, 1], spacing: 1 cm}
terrain: {type: raster, file: bed.asc}
sand:
  friction_angle: 30 deg
  hbar: {policy: full}
  initial: {type: box, from: [2 cm, 0 m], to: [4 cm, 1 cm], depth: 1 cm}
time: {end: 100 ms, frame_interval: 50 ms}
)");
  const auto write_bed = [&](const std::string& heights) {
    write_text(place.folder / "bed.asc", "ncols 2\nnrows 2\nxllcenter -1\nyllcenter -1\ncellsize 2\n" + heights + "\n");
  };
  write_bed("0 0\n0 0");
  const std::vector<std::string> vary{"--vary", "gravity=9,10 m/s^2"};
  const Outcome first = place.sweep(vary);
  INFO(first.err);
  REQUIRE(first.code == 0);
  write_bed("0 0.5\n0 0.5");
  CHECK(place.sweep(vary).code == 6);
  CHECK(place.sweep({vary[0], vary[1], "--overwrite"}).code == 0);
}

TEST_CASE("a sweep file names its scene and what varies") {
  const Workplace place;
  write_text(place.folder / "sweep.yaml", R"(scene: scene.yaml
set: {time.frame_interval: 50 ms}
vary:
  - {gravity: 8..10 m/s^2}
  - {sand.hbar.policy: [full], sand.friction_angle: [25 deg]}
samples: 3
sampling: random
seed: 5
)");
  const std::string file = (place.folder / "sweep.yaml").string();
  const Outcome outcome = call({"sweep", file, "--list"});
  INFO(outcome.err);
  CHECK(outcome.code == 0);
  CHECK(contains(outcome.out, "    3  cases/"));
  CHECK(contains(outcome.out, "sand.hbar.policy=full, sand.friction_angle=25 deg, gravity=8."));
  CHECK(call({"sweep", place.folder.path().string(), "--list"}).out == outcome.out);
  CHECK(call({"sweep", file, "--list", "--seed", "6"}).out != outcome.out);
  write_text(place.folder / "sweep.yaml", "scene: scene.yaml\nvari: {gravity: 3}\nvary: {gravity: 20:40}\nseed: -1\n");
  const Outcome bad = call({"sweep", file});
  CHECK(bad.code == 2);
  CHECK(contains(bad.err, "sweep.yaml:2:1: vari: unknown key of a sweep. Did you mean 'vary'?"));
  CHECK(contains(bad.err, "sweep.yaml:3:8: gravity = 20:40: not a range"));
  CHECK(contains(bad.err, "sweep.yaml:4:1: seed = -1: a whole number is needed"));
}

TEST_CASE("sweeps that make no sense say why and run nothing") {
  const Workplace place;
  const auto problem = [&](const std::vector<std::string>& more, int code) {
    const Outcome outcome = call(place.arguments(more));
    CHECK(outcome.code == code);
    CHECK_FALSE(fs::exists(place.results));
    return outcome.err;
  };
  CHECK(contains(problem({}, 1), "nothing varies"));
  CHECK(contains(problem({"--vary", "sand.fricton_angle=20,30 deg"}, 2), "Did you mean 'friction_angle'?"));
  CHECK(contains(problem({"--vary", "sand.friction_angle=20:30:3"}, 2), "an angle needs a unit"));
  CHECK(contains(problem({"--vary", "sand.friction_angle=20 deg:1 rad:3"}, 1), "mixed units ('deg' and 'rad')"));
  CHECK(contains(problem({"--vary", "sand.friction_angle=20:20:3 deg"}, 1), "an empty range"));
  CHECK(contains(problem({"--vary", "gravity=1:9:1000 m/s^2", "--vary", "time.end=1:9:1000 s"}, 1), "1,000,000 cases"));
  CHECK(contains(problem({"--vary", "gravity=1:9:1001 m/s^2", "--vary", "time.end=1:9:1000 s", "--yes"}, 1),
                 "more than 1,000,000 cases"));
  CHECK(contains(problem({"--vary", "gravity=1..9 m/s^2"}, 1), "--samples"));
  CHECK(contains(problem({"--vary", "sand.friction_angle=30 deg,30.0 deg"}, 2), "cases 1 and 2 are the same scene"));
  CHECK(contains(problem({"--vary", "gravity=1,2 m/s^2", "--list", "--collect"}, 1), "excludes"));
  write_text(place.folder / "gone.yaml", "scene: nowhere.yaml\nvary: {gravity: [1 m/s^2]}\n");
  CHECK(call({"sweep", (place.folder / "gone.yaml").string()}).code == 3);
}
