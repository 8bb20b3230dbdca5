// Many runs side by side as processes, and what is read back from them.
#include "cli/cases/case_pool.hpp"

#include <signal.h>

#include <memory>

#include "cli/cases/case_report.hpp"
#include "series_values.hpp"
#include "support.hpp"
#include "tests/support/catch.hpp"

using namespace sandsim::cli;
using namespace sandsim::test;
using Catch::Matchers::WithinAbs;
namespace fs = std::filesystem;

namespace {

struct Cases {
  Cases() { write_text(scene, small_scene()); }

  CaseJob job(const std::string& name, const std::vector<std::string>& overrides = {}) const {
    return {name, scene, overrides, folder / name, true, {"--threads", "1"}};
  }
  PoolSettings settings(int parallel) const {
    PoolSettings settings;
    settings.parallel = parallel;
    settings.executable = SANDSIM_BINARY_DIR "/bin/sandsim";
    return settings;
  }

  TemporaryDirectory folder;
  fs::path scene = folder / "scene.yaml";
};

}  // namespace

TEST_CASE("cases side by side have the bits of single runs") {
  const Cases cases;
  const std::vector<CaseJob> jobs{cases.job("a"), cases.job("b", {"sand.friction_angle=20 deg"}), cases.job("c")};
  std::size_t started = 0, ended = 0;
  PoolObserver observer;
  observer.started = [&](std::size_t) { ++started; };
  observer.ended = [&](std::size_t, const CaseOutcome&) { ++ended; };
  const PoolResult result = run_cases(jobs, cases.settings(2), observer);
  CHECK(started == 3);
  CHECK(ended == 3);
  CHECK_FALSE(result.interrupted);
  for (const CaseOutcome& outcome : result.outcomes) {
    INFO(outcome.error_text);
    CHECK(outcome.is_done());
    CHECK(outcome.wall_seconds > 0.0);
  }
  const fs::path single = cases.folder / "single";
  const std::string angle = "sand.friction_angle=20 deg";
  REQUIRE(call({"run", cases.scene.string(), "-q", "-o", single.string(), "--set", angle}).code == 0);
  CHECK(differing_values(cases.folder / "b" / "series.h5", single / "series.h5").empty());
  CHECK_FALSE(differing_values(cases.folder / "a" / "series.h5", single / "series.h5").empty());
}

TEST_CASE("a case that fails is an outcome and the others go on") {
  const Cases cases;
  write_text(cases.folder / "blocked", "a file where a directory should be");
  const std::vector<CaseJob> jobs{cases.job("bad", {"gravity=-1 m/s^2"}), cases.job("blocked"), cases.job("good")};
  const PoolResult result = run_cases(jobs, cases.settings(1));
  CHECK(result.outcomes[0].exit_code == 2);
  CHECK(contains(result.outcomes[0].error_text, "gravity"));
  CHECK(result.outcomes[1].exit_code == 6);
  CHECK(contains(result.outcomes[1].error_text, "blocked"));
  CHECK(result.outcomes[2].is_done());
}

TEST_CASE("a program that cannot be started is an outcome") {
  const Cases cases;
  PoolSettings settings = cases.settings(1);
  settings.executable = cases.folder / "nowhere";
  const std::vector<CaseJob> jobs{cases.job("a")};
  const CaseOutcome outcome = run_cases(jobs, settings).outcomes[0];
  CHECK(outcome.exit_code == 127);
  CHECK(contains(outcome.error_text, "cannot be started"));
}

TEST_CASE("a signal starts no more cases and reaches the running ones, which can be resumed") {
  const Cases cases;
  write_text(cases.scene, endless_scene());
  const std::vector<CaseJob> jobs{cases.job("a"), cases.job("b")};
  PoolObserver observer;
  bool raised = false;  // a second one would kill
  observer.tick = [&](std::span<const RunningCase> running) {
    if (!raised && !running.empty() && running[0].progress.time > 0.0) {
      raised = true;
      raise(SIGTERM);
    }
  };
  const PoolResult result = run_cases(jobs, cases.settings(1), observer);
  CHECK(result.interrupted);
  CHECK(result.signal == "SIGTERM");
  CHECK(result.outcomes[0].exit_code == 130);
  CHECK(fs::exists(cases.folder / "a" / "checkpoint.h5"));
  CHECK_FALSE(result.outcomes[1].started);
  const auto report = read_case_report(cases.folder / "a");
  REQUIRE(report);
  CHECK(report->run.status == "interrupted");
  const std::vector<std::string> short_end{"time.end=1 s"};
  CHECK(run_cases(std::vector<CaseJob>{cases.job("a", short_end)}, cases.settings(1)).outcomes[0].exit_code == 3);
}

TEST_CASE("a case whose directory another process has locked waits for it") {
  const Cases cases;
  const std::vector<CaseJob> jobs{cases.job("locked"), cases.job("free")};
  auto lock = std::make_unique<sandsim::FileLock>(lock_case(cases.folder / "locked"));
  REQUIRE(lock->taken());
  CHECK_FALSE(lock_case(cases.folder / "locked").taken());
  std::vector<std::size_t> order;
  PoolObserver observer;
  observer.ended = [&](std::size_t index, const CaseOutcome&) {
    order.push_back(index);
    lock.reset();
  };
  run_cases(jobs, cases.settings(2), observer);
  CHECK(order == std::vector<std::size_t>{1, 0});
}

TEST_CASE("the report of a case holds its run and its runout") {
  const Cases cases;
  write_text(cases.scene, R"(grid: {cells: [16, 1], spacing: 1 cm}
sand:
  friction_angle: 45 deg
  hbar: {policy: full}
  initial: {type: box, from: [4 cm, 0 m], to: [8 cm, 1 cm], depth: 1 mm}
time: {end: 100 ms, frame_interval: 50 ms, stop_at_rest: true}
reference: {front_depths: [0.5 mm]}
)");
  REQUIRE(call({"run", cases.scene.string(), "-q", "-o", (cases.folder / "a").string()}).code == 0);
  const auto report = read_case_report(cases.folder / "a");
  REQUIRE(report);
  CHECK(report->run.status == "at rest");
  CHECK(report->run.at_rest);
  CHECK(report->run.cells == 16);
  REQUIRE(report->run.errors.size() == 1);
  REQUIRE(report->run.errors[0].fronts.size() == 1);
  CHECK(report->run.errors[0].fronts[0].depth == 5e-4);
  CHECK(report->scene_hash.starts_with("fnv1a64:"));
  // A step of 1 mm on cells of 1 cm is less steep than 45 deg: the box stays as it is, up to float32.
  REQUIRE(report->run.runout);
  CHECK_THAT(report->run.runout->deposit_height, WithinAbs(1e-3, 1e-9));
  // From the last centre at 7.5 cm to the next one the depth falls to a hundredth: 0.99 of a cell further.
  CHECK_THAT(report->run.runout->deposit_front, WithinAbs(0.0849, 1e-9));
  CHECK(report->run.runout->front.distance == 0.0);
  CHECK_FALSE(read_case_report(cases.folder / "nothing"));
  write_text(cases.folder / "broken" / "run.json", "{\"status\": ");
  CHECK_FALSE(read_case_report(cases.folder / "broken"));
}
