// run.json read back.
#include "io/output/read_run_report.hpp"

#include <cmath>
#include <limits>

#include "fixtures.hpp"
#include "io/output/run_report.hpp"
#include "solver/errors.hpp"
#include "tests/support/catch.hpp"

using namespace sandsim;
using namespace sandsim::test;

TEST_CASE("a run report reads back as it was written") {
  const TemporaryDirectory folder;
  RunReport report;
  report.status = "at rest";
  report.exit_code = ExitCode::done;
  report.message = "a \"quoted\" word,\n  and a line";
  report.device = "cpu";
  report.threads = 3;
  report.precision = "float32";
  report.scheme = "balanced";
  report.order = 2;
  report.cells = 12345678901;
  report.steps = 7;
  report.wall_time = 0.1;
  report.stages = {{"step", 0.25, 7, 1e9}};
  report.ledger = {1.0, 1.5, 0.75, 0.25, 1e-20};
  report.at_rest = true;
  report.stop_time = 1.0 / 3.0;
  report.max_slope_violation = std::numeric_limits<double>::quiet_NaN();
  ErrorReport error;
  error.against = "exact";
  error.l1 = 1e-3;
  error.fronts = {{0.005, 1.25, std::nullopt}, {0.0, 1.5, 1.75}};
  error.height = {0.25, 0.5};
  report.errors = {error};
  report.runout = RunoutReport{0.01, {120.0, 60.0}, {}, 800.0, 2.5, 30.0, std::nan(""), 0.75};
  RunContext context;
  context.scene_hash = "fnv1a64:0123456789abcdef";
  write_text(folder / "run.json", run_report_json(report, context));

  const StoredRun stored = read_run_report(folder / "run.json");
  CHECK(stored.scene_hash == context.scene_hash);
  const RunReport& read = stored.report;
  CHECK(read.status == report.status);
  CHECK(read.message == report.message);
  CHECK(read.threads == 3);
  CHECK(read.cells == 12345678901);
  CHECK(read.wall_time == 0.1);
  REQUIRE(read.stages.size() == 1);
  CHECK(read.stages[0].seconds == 0.25);
  CHECK(read.stages[0].launches == 7);
  CHECK(read.ledger.error() == report.ledger.error());
  CHECK(read.ledger.clipped == 1e-20);
  CHECK(read.at_rest);
  CHECK(read.stop_time == 1.0 / 3.0);
  CHECK(std::isnan(read.max_slope_violation));
  REQUIRE(read.runout);
  CHECK(read.runout->above == 0.01);
  CHECK(read.runout->front.distance == 120.0);
  CHECK(read.runout->front.travel_angle() == std::atan(0.5));
  CHECK(std::isnan(read.runout->center_of_mass.drop));
  CHECK(read.runout->area == 800.0);
  CHECK(read.runout->max_depth == 2.5);
  CHECK(read.runout->max_speed == 30.0);
  CHECK(std::isnan(read.runout->deposit_front));
  CHECK(read.runout->deposit_height == 0.75);
  REQUIRE(read.errors.size() == 1);
  CHECK(read.errors[0].l1 == 1e-3);
  CHECK_FALSE(read.errors[0].l2);
  REQUIRE(read.errors[0].height);
  CHECK(read.errors[0].height->reference == 0.5);
  REQUIRE(read.errors[0].fronts.size() == 2);
  CHECK_FALSE(read.errors[0].fronts[0].reference);
  CHECK(read.errors[0].fronts[1].reference == 1.75);
}

TEST_CASE("what is no run report is refused") {
  const TemporaryDirectory folder;
  CHECK_THROWS_AS(read_run_report(folder / "nowhere.json"), InputError);
  for (const char* text :
       {"", "{", "[1, 2]", "{\"status\": \"done\"}", "{\"status\": \"done\", \"exit_code\": \"x\"}"}) {
    write_text(folder / "run.json", text);
    CHECK_THROWS_AS(read_run_report(folder / "run.json"), InputError);
  }
}
