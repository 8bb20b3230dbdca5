// `sandsim study`: studies from files, what they leave behind, and what they say about bad ones.
#include <signal.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "support.hpp"
#include "tests/support/catch.hpp"

namespace sandsim::test {
namespace {

using Row = std::map<std::string, std::string>;

/// Cells of one line of CSV; quotes around cells with commas.
std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  return cells;
}

std::vector<Row> read_csv(const std::filesystem::path& path) {
  std::istringstream lines(read_text(path));
  std::string line;
  std::getline(lines, line);
  const std::vector<std::string> head = cells_of(line);
  std::vector<Row> rows;
  while (std::getline(lines, line)) {
    const std::vector<std::string> cells = cells_of(line);
    REQUIRE(cells.size() == head.size());
    for (std::size_t k = 0; k < head.size(); ++k) {
      (k == 0 ? rows.emplace_back() : rows.back())[head[k]] = cells[k];
    }
  }
  return rows;
}

/// A folder with a scene that knows its deposit well enough, and a study of it.
struct Workplace {
  TemporaryDirectory folder;

  explicit Workplace(const std::string& study, const std::string& more = "reference: {profile: deposit.csv}\n") {
    write_text(folder / "scene.yaml", small_scene() + more);
    write_text(folder / "deposit.csv", "x_m,depth_m\n0.0,0.045\n0.05,0.035\n0.10,0.02\n0.15,0.005\n0.2,0\n");
    write_text(folder / "study.yaml", study);
  }
  Outcome run(std::vector<std::string> options = {}) const {
    std::vector<std::string> words{"study", (folder / "study.yaml").string(), "-o", (folder / "out").string()};
    words.insert(words.end(), options.begin(), options.end());
    return call(words);
  }
  std::string place(const std::string& line_and_column) const {
    return (folder / "study.yaml").string() + ':' + line_and_column + ": ";
  }
};

const std::string tiny_study = R"(title: Tiny
scenes: {name: dam, file: scene.yaml}
spacings: [2 cm, 1 cm]
methods:
  - {name: "first, order", set: {numerics: {scheme: balanced, order: 1}}}
  - {name: second, set: {numerics.order: 2}}
vary: {numerics.precision: [float32, float64]}
repeats: 1
)";

}  // namespace

TEST_CASE("a study tabulates errors, times and orders of every setting") {
  const Workplace place(tiny_study);
  const Outcome outcome = place.run();
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  CHECK(contains(outcome.out, "## dam"));
  CHECK(contains(outcome.out, "| first, order, float32 |"));
  CHECK(contains(outcome.out, "Frontier"));
  CHECK(contains(outcome.out, "Load average"));
  CHECK(read_text(place.folder / "out/table.md") == outcome.out.substr(0, outcome.out.rfind("\nTables and numbers")));
  const std::vector<Row> rows = read_csv(place.folder / "out/study.csv");
  REQUIRE(rows.size() == 8);
  for (const Row& row : rows) {
    CAPTURE(row.at("setting"), row.at("spacing_m"));
    const double error = std::stod(row.at("error"));
    CHECK(error > 0.0);
    CHECK(row.at("error") == row.at("l1_relative"));
    CHECK(std::stod(row.at("l1")) > 0.0);
    CHECK(std::stod(row.at("l2")) > 0.0);
    CHECK(std::stod(row.at("linf_m")) > 0.0);
    CHECK(std::stod(row.at("height_m")) > 0.0);
    CHECK(std::stod(row.at("seconds")) > 0.0);
    CHECK(std::stod(row.at("bytes")) > 0.0);
    CHECK(std::stod(row.at("cell_steps")) == std::stod(row.at("cells")) * std::stod(row.at("steps")));
    // The same domain of 40 cm on both grids.
    CHECK(std::stod(row.at("cells")) * std::stod(row.at("spacing_m")) == 0.4);
    CHECK(row.at("order").empty() == (row.at("spacing_m") == "0.02"));
  }
  // Half the spacing: the order is the logarithm of the errors' ratio.
  CHECK_THAT(std::stod(rows[1].at("order")),
             WithinRel(std::log2(std::stod(rows[0].at("error")) / std::stod(rows[1].at("error"))), 1e-12));
}

TEST_CASE("a study's own copy gives the same errors to the last digit") {
  const Workplace place(tiny_study);
  REQUIRE(place.run().code == 0);
  const std::string again = (place.folder / "again").string();
  const Outcome outcome = call({"study", (place.folder / "out/study.yaml").string(), "-o", again, "-q"});
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  CHECK(outcome.out.empty());
  const std::vector<Row> first = read_csv(place.folder / "out/study.csv"),
                         second = read_csv(place.folder / "again/study.csv");
  REQUIRE(first.size() == second.size());
  for (std::size_t k = 0; k < first.size(); ++k) {
    for (const auto& [key, value] : first[k]) {
      if (key == "seconds" || key == "least_s" || key == "most_s" || key == "frontier") {
        continue;
      }
      CAPTURE(k, key);
      CHECK(second[k].at(key) == value);
    }
  }
  CHECK(read_text(place.folder / "again/study.yaml") == read_text(place.folder / "out/study.yaml"));
}

TEST_CASE("a study observes the orders of the verification tests in the bowl with friction") {
  const TemporaryDirectory folder;
  write_text(folder / "bowl.yaml", R"(scenes: {file: )" SANDSIM_SOURCE_DIR R"(/scenes/bowl/scene.yaml}
spacings: [2 cm, 1 cm]
methods:
  - {name: two, set: {numerics: {order: 2, precision: float64}}}
  - {name: one, set: {numerics: {order: 1, precision: float64}}}
  - {name: paper, set: {numerics: {scheme: paper, velocity: quotient, precision: float64}}}
repeats: 1
)");
  const Outcome outcome = call({"study", (folder / "bowl.yaml").string(), "-o", (folder / "out").string()});
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  const std::vector<Row> rows = read_csv(folder / "out/study.csv");
  REQUIRE(rows.size() == 6);
  const auto error = [&](std::size_t k) { return std::stod(rows[k].at("error")); };
  const auto order = [&](std::size_t k) { return std::stod(rows[k].at("order")); };
  // The bounds of tests/verification/converge_smooth.cpp, for the same grids.
  CHECK(error(1) <= 3.7e-4);
  CHECK(order(1) >= 1.6);
  CHECK(error(3) <= 4.7e-3);
  CHECK(order(3) >= 0.85);
  CHECK(error(5) <= 3.3e-3);
  CHECK(order(5) >= 0.85);
}

TEST_CASE("a study without a reference makes a fine run once and keeps it") {
  const Workplace place(R"(scenes: {file: scene.yaml}
spacings: [2 cm, 1 cm]
fine: {spacing: 2.5 mm}
repeats: 1
)",
                        "");
  const Outcome first = place.run(), second = place.run({"--overwrite"});
  INFO(first.err << second.err);
  REQUIRE(first.code == 0);
  REQUIRE(second.code == 0);
  CHECK(contains(first.err, "kept in"));
  CHECK(contains(second.err, "taken from"));
  const std::vector<Row> rows = read_csv(place.folder / "out/study.csv");
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].at("against") == "fine run");
  CHECK(std::stod(rows[1].at("error")) < std::stod(rows[0].at("error")));
}

TEST_CASE("a study of one setting runs and says that it has neither an order nor a frontier") {
  const Workplace place("scenes: {file: scene.yaml}\nrepeats: 1\n");
  const Outcome outcome = place.run();
  INFO(outcome.err);
  CHECK(outcome.code == 0);
  CHECK(contains(outcome.out, "No order can be observed: that takes two spacings"));
  CHECK(contains(outcome.out, "No frontier of '" + place.folder.path().filename().string() + "'"));
  CHECK(read_csv(place.folder / "out/study.csv").size() == 1);
}

TEST_CASE("an ablation compares variants with their base") {
  const Workplace place(R"(ablation:
  file: scene.yaml
  set: {time: {mode: fixed, step: 1 ms, end: 50 ms, frame_interval: 10 ms}}
  base: plain
  variants:
    - {name: maxima, set: {output.maxima: true}}
    - {name: float64, set: {numerics.precision: float64}}
  writes: true
repeats: 2
)");
  const Outcome outcome = place.run();
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  CHECK(contains(outcome.out, "What features cost"));
  const std::vector<Row> rows = read_csv(place.folder / "out/ablation.csv");
  REQUIRE(rows.size() == 3);
  CHECK(rows[0].at("variant") == "plain");
  CHECK(rows[0].at("wall_ratio") == "1");
  CHECK(rows[0].at("stages") == "step, frames");
  CHECK(rows[1].at("stages") == "step, maxima, frames");
  CHECK(std::stod(rows[1].at("bytes_per_cell_step")) > std::stod(rows[0].at("bytes_per_cell_step")));
  CHECK(std::stod(rows[2].at("bytes_per_cell_step")) == 2.0 * std::stod(rows[0].at("bytes_per_cell_step")));
  for (const Row& row : rows) {
    CHECK(row.at("steps") == "50");
    CHECK(std::stod(row.at("ratio_least")) <= std::stod(row.at("ratio_most")));
  }
  // The frames that were written are gone.
  CHECK_FALSE(std::filesystem::exists(place.folder / "out/scratch.h5"));
}

TEST_CASE("a setting that fails has its row, and the others are run") {
  const Workplace place(R"(scenes: {file: scene.yaml}
methods:
  - {name: good, set: {numerics.order: 1}}
  - {name: bad, set: {time.mode: fixed, time.step: 20 ms}}
repeats: 1
)");
  const Outcome outcome = place.run();
  CHECK(outcome.code == 5);
  CHECK(contains(outcome.err, "longer than the stability bound"));
  CHECK(contains(outcome.out, "failed"));
  const std::vector<Row> rows = read_csv(place.folder / "out/study.csv");
  REQUIRE(rows.size() == 2);
  CHECK(std::stod(rows[0].at("error")) > 0.0);
  CHECK(rows[1].at("status") == "failed");
  CHECK(rows[1].at("error").empty());
}

TEST_CASE("a fixed step falls with the spacing") {
  const Workplace place(
      R"(scenes: {file: scene.yaml, set: {time: {mode: fixed, step: 5 ms, end: 40 ms, frame_interval: 10 ms}}}
spacings: [2 cm, 1 cm]
repeats: 1
)");
  const Outcome outcome = place.run();
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  const std::vector<Row> rows = read_csv(place.folder / "out/study.csv");
  CHECK(rows.at(0).at("steps") == "8");
  CHECK(rows.at(1).at("steps") == "16");
}

TEST_CASE("a fixed step that no longer divides the time is reported") {
  const Workplace place(
      R"(scenes: {file: scene.yaml, set: {time: {mode: fixed, step: 5 ms, end: 40 ms, frame_interval: 10 ms}}}
spacings: [4 cm, 2.5 cm]
repeats: 1
)");
  const Outcome outcome = place.run();
  CHECK(outcome.code == 2);
  CHECK(contains(outcome.err, place.place("2:1") + "spacings = [4 cm, 2.5 cm]: a fixed step of 0.003125 s"));
}

TEST_CASE("A list of a study names the settings and runs nothing") {
  const Workplace place(tiny_study);
  const Outcome outcome = place.run({"--list", "--quick"});
  CHECK(outcome.code == 0);
  CHECK(contains(outcome.out, "dam, second, float64, 40 x 1 cells of 0.01 m"));
  CHECK(contains(outcome.out, "8 settings, 0 variants, 1 repeats"));
  CHECK_FALSE(std::filesystem::exists(place.folder / "out"));
}

TEST_CASE("an output directory that is not empty is refused without --overwrite") {
  const Workplace place(tiny_study);
  write_text(place.folder / "out/mine.txt", "mine");
  CHECK(place.run().code == 6);
  CHECK(place.run({"--overwrite"}).code == 0);
  CHECK(read_text(place.folder / "out/mine.txt") == "mine");
}

TEST_CASE("an interrupted study leaves tables of what it has and exits 130") {
  const TemporaryDirectory folder;
  write_text(folder / "scene.yaml", endless_scene());
  write_text(folder / "study.yaml",
             "ablation: {file: scene.yaml, variants: [{name: order 1, set: {numerics.order: 1}}]}\n");
  Process process({"study", (folder / "study.yaml").string(), "-o", (folder / "out").string()}, folder.path());
  REQUIRE(wait_until([&] { return std::filesystem::exists(folder / "out/study.yaml"); }));
  process.send(SIGINT);
  const Outcome outcome = process.wait();
  CHECK(outcome.code == 130);
  CHECK(contains(read_text(folder / "out/table.md"), "Interrupted by SIGINT"));
}

// ---- bad studies ----------------------------------------------------------------------------------------------------
TEST_CASE("bad values of a study are reported at their places with exit code 2") {
  struct Bad {
    std::string study, place, message;
  };
  const std::vector<Bad> all{
      {"scenes: {file: scene.yaml}\nspacing: [1 cm]\n", "2:1", "spacing: unknown key. Did you mean 'spacings'?"},
      {"scenes: {file: scene.yaml}\nspacings: [3 cm]\n", "2:1",
       "0.03 m does not divide the domain (it is 0.4 m long in x)"},
      {"scenes: {file: scene.yaml}\nspacings: [1 cm, 1 cm]\n", "2:1", "a value is given twice"},
      {"scenes: {file: scene.yaml}\nspacings: [1]\n", "2:12", "spacings.0 = 1: a length needs a unit"},
      {"scenes: {file: scene.yaml}\nerror: {measure: l3}\n", "2:9", "error.measure = l3: unknown value"},
      {"scenes: {file: scene.yaml}\nerror: {against: exact}\n", "2:9", "has none (or its file is not there yet)"},
      {"scenes: {file: scene.yaml}\nerror: {against: fine}\n", "2:9", "there is no fine run"},
      {"scenes: {file: scene.yaml}\nfine: {spacing: 1 mm}\nerror: {against: profile}\n", "3:9",
       "the study has a fine run"},
      {"scenes: {file: scene.yaml}\nfine: {spacing: 2 cm}\n", "2:8", "not finer than the scene"},
      {"scenes: {file: scene.yaml}\nmethods: [{name: a, set: {}}, {name: a, set: {}}]\n", "2:32", "given twice"},
      {"scenes: {file: scene.yaml}\nvary: {grid.spacing: [1 cm]}\n", "2:8", "Use spacings."},
      {"scenes: {file: scene.yaml}\nvary: {numerics.order: 1}\n", "2:8", "a list is needed"},
      {"scenes: [{file: scene.yaml}, {file: scene.yaml}]\n", "1:30", "a second scene named"},
      {"title: Nothing\n", "1:1", "scenes: missing (there is nothing to measure)"},
      {small_scene(), "1:1", "this is a scene, not a study"},
      // In the scene, but written here:
      {"scenes: {file: scene.yaml}\nset: {numerics.ordr: 1}\n", "2:7",
       "numerics.ordr: unknown key. Did you mean 'order'?"},
      {"scenes: {file: scene.yaml}\nvary: {numerics.order: [1, 3]}\n", "2:28", "numerics.order = 3: out of range"},
  };
  for (const Bad& bad : all) {
    const Workplace place(bad.study);
    const Outcome outcome = place.run();
    INFO(bad.study << outcome.err);
    CHECK(outcome.code == 2);
    CHECK(contains(outcome.err, place.place(bad.place)));
    CHECK(contains(outcome.err, bad.message));
    CHECK_FALSE(std::filesystem::exists(place.folder / "out"));
  }
}

TEST_CASE("a scene without a reference needs a fine run") {
  const Workplace place("scenes: [{file: scene.yaml}]\n", "");
  const Outcome outcome = place.run();
  CHECK(outcome.code == 2);
  CHECK(contains(outcome.err, place.place("1:10")));
  CHECK(contains(outcome.err, "has no reference to take errors against"));
  CHECK(contains(outcome.err, "\"fine: {spacing: 1 mm}\" to the study"));
}

TEST_CASE("a reference that does not overlap with the scene is an error of the scene") {
  const Workplace place(
      "scenes: {file: scene.yaml, set: {grid.origin: [5 m, 0 m], sand.initial.0: {type: layer, depth: 1 cm}}}\n");
  const Outcome outcome = place.run();
  CHECK(outcome.code == 2);
  CHECK(contains(outcome.err, "reference.profile = deposit.csv: does not overlap with the grid"));
}

TEST_CASE("a problem of a scene that only some settings have names the first of them") {
  const Workplace place("scenes: {file: scene.yaml}\nmethods: [{name: mine, set: {numerics.scheme: paper}}]\n");
  const Outcome outcome = place.run();
  CHECK(outcome.code == 2);
  CHECK(contains(outcome.err, "scene.yaml:11:"));
  CHECK(contains(outcome.err, "\n  with 'mine', spacing 0.01 m of"));
}

TEST_CASE("a problem that many settings share is reported once") {
  const Workplace place("scenes: {file: scene.yaml}\nset: {numerics.order: 3}\nvary: {time.courant: [0.3, 0.6]}\n");
  const Outcome outcome = place.run();
  CHECK(outcome.code == 2);
  const std::size_t first = outcome.err.find("out of range");
  REQUIRE(first != std::string::npos);
  CHECK(outcome.err.find("out of range", first + 1) == std::string::npos);
}

TEST_CASE("an empty study says how to begin") {
  const Workplace place("\n");
  const Outcome outcome = place.run();
  CHECK(outcome.code == 2);
  CHECK(contains(outcome.err, "the study is empty (it holds no key). Start with \"scenes: ...\"."));
}

TEST_CASE("a study or a scene that is not there exits 3") {
  const TemporaryDirectory folder;
  CHECK(call({"study", (folder / "none.yaml").string()}).code == 3);
  const Workplace place("scenes: {file: nowhere.yaml}\n");
  const Outcome outcome = place.run();
  CHECK(outcome.code == 3);
  CHECK(contains(outcome.err, "nowhere.yaml: there is no such scene"));
}

}  // namespace sandsim::test
