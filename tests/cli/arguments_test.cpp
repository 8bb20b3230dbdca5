#include "support.hpp"
#include "tests/support/catch.hpp"

using namespace sandsim::test;

TEST_CASE("help goes to standard output and exits 0") {
  const Outcome outcome = call({"--help"});
  CHECK(outcome.code == 0);
  CHECK(outcome.err.empty());
  CHECK(contains(outcome.out, "Exit codes:"));
  CHECK(contains(outcome.out, "Examples:"));
}

TEST_CASE("every command has a help with an example") {
  for (const char* command : {"run", "check", "info", "export", "schema", "devices", "bench"}) {
    INFO(command);
    const Outcome outcome = call({command, "--help"});
    CHECK(outcome.code == 0);
    CHECK(contains(outcome.out, std::string("\n  sandsim ") + command));
  }
}

TEST_CASE("the help of run names the default directory") {
  CHECK(contains(call({"run", "--help"}).out, "results/NAME"));
}

TEST_CASE("the version names the program") {
  const Outcome outcome = call({"--version"});
  CHECK(outcome.code == 0);
  CHECK(outcome.out.starts_with("sandsim "));
}

TEST_CASE("usage errors exit 1 and name what is wrong") {
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{}, "no command"},
      {{"rnu", "scene.yaml"}, "unknown command 'rnu'"},
      {{"--frob"}, "A subcommand is required"},
      {{"run"}, "SCENE is required"},
      {{"run", "a.yaml", "b.yaml"}, "b.yaml"},
      {{"run", "a.yaml", "--frob"}, "--frob"},
      {{"run", "a.yaml", "-o"}, "--output"},
      {{"run", "a.yaml", "--threads", "0"}, "--threads"},
      {{"run", "a.yaml", "--threads", "two"}, "--threads"},
      {{"run", "a.yaml", "--threads", "1", "--threads", "2"}, "--threads"},
      {{"run", "a.yaml", "--device", "tpu"}, "'tpu' is none of auto, cpu, cuda"},
      {{"run", "a.yaml", "--precision", "half"}, "'half' is none of float32, float64"},
      {{"run", "a.yaml", "--max-wall", "90"}, "'90' is not HH:MM:SS"},
      {{"run", "a.yaml", "--resume", "--overwrite"}, "--overwrite"},
      {{"run", "a.yaml", "-q", "-v"}, "--quiet"},
      {{"run", "a.yaml", "--set"}, "--set"},
      {{"bench", "--size", "4"}, "--size"},
      {{"bench", "--device", "auto"}, "'auto' is none of cpu, cuda"},
      {{"info"}, "RESULT is required"},
  };
  for (const auto& [args, expected] : cases) {
    const Outcome outcome = call(args);
    INFO(outcome.err);
    CHECK(outcome.code == 1);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.starts_with("sandsim: error: "));
    CHECK(contains(outcome.err, expected));
    CHECK(contains(outcome.err, "--help"));
  }
}

TEST_CASE("each set option takes one value so that the scene may follow it") {
  // The scene is missing: that it is named shows that it was not taken for a second value.
  const Outcome outcome = call({"check", "--set", "time.end=1 s", "--set", "gravity=9 m/s^2", "no_such_scene.yaml"});
  CHECK(outcome.code == 3);
  CHECK(contains(outcome.err, "no_such_scene.yaml"));
}

TEST_CASE("devices lists the processor and says whether CUDA is there") {
  const Outcome outcome = call({"devices"});
  CHECK(outcome.code == 0);
  CHECK(contains(outcome.out, "cpu "));
  CHECK(contains(outcome.out, "cuda "));
}

TEST_CASE("the schema is a JSON document and the reference a page") {
  CHECK(call({"schema"}).out.starts_with("{"));
  CHECK(contains(call({"schema", "--reference"}).out, "# "));
}
