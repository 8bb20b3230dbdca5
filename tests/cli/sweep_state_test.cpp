// What the states of cases mean for what is run, and for the exit code.
#include "cli/sweep/case_state.hpp"
#include "cli/sweep/sweep_display.hpp"
#include "cli/sweep/sweep_table.hpp"
#include "support.hpp"
#include "tests/support/catch.hpp"

using namespace sandsim;
using namespace sandsim::cli;
using namespace sandsim::test;
using Kind = CaseState::Kind;

namespace {

CaseState state(Kind kind, int exit_code) {
  return {kind, exit_code, "", "", std::nullopt};
}

const CaseState not_run = state(Kind::not_run, 0);
const CaseState done = state(Kind::done, 0);
const CaseState interrupted = state(Kind::interrupted, 130);
const CaseState broke_down = state(Kind::failed, 5);
const CaseState disk_full = state(Kind::failed, 6);
const CaseState killed = state(Kind::failed, 137);
const CaseState invalid = state(Kind::failed, 2);

}  // namespace

TEST_CASE("cases are run again if another run could end in another way") {
  CHECK(is_to_be_run(not_run, false));
  CHECK(is_to_be_run(interrupted, false));
  CHECK(is_to_be_run(disk_full, false));
  CHECK(is_to_be_run(killed, false));
  CHECK_FALSE(is_to_be_run(done, false));
  CHECK_FALSE(is_to_be_run(broke_down, false));
  CHECK_FALSE(is_to_be_run(invalid, false));
  CHECK(is_to_be_run(broke_down, true));
  CHECK_FALSE(is_to_be_run(done, true));
  CHECK_FALSE(is_to_be_run(invalid, true));
}

TEST_CASE("a sweep's exit code is that of the first case that failed") {
  CHECK(exit_code_of({done, done}) == ExitCode::done);
  CHECK(exit_code_of({done, interrupted, disk_full, broke_down}) == ExitCode::output);
  CHECK(exit_code_of({done, not_run, interrupted}) == ExitCode::interrupted);
  CHECK(exit_code_of({done, not_run}) == ExitCode::missing_input);
}

TEST_CASE("what a process says outweighs a report that it did not get to write") {
  const TemporaryDirectory folder;
  const Sweep sweep{"scene.yaml", {}, {"gravity"}, {{{"9 m/s^2"}, "cases/a", "fnv1a64:0", ""}}, {}};
  CaseOutcome crashed;
  crashed.started = true;
  crashed.exit_code = 128 + 11;
  const CaseState after = case_state(sweep, 0, folder.path(), crashed);
  CHECK(after.kind == Kind::failed);
  CHECK(after.status == "killed by signal 11");
  CaseOutcome full;
  full.started = true;
  full.exit_code = 6;
  full.error_text = "sandsim: error: no space left\n  free some\n";
  CHECK(case_state(sweep, 0, folder.path(), full).message == "no space left");
  CHECK(case_state(sweep, 0, folder.path(), CaseOutcome{}).kind == Kind::not_run);
}

TEST_CASE("parameters are numbers where all their values have the same unit") {
  Sweep sweep{"scene.yaml", {}, {"a", "b", "c"}, {}, {}};
  sweep.cases.push_back({{"20 deg", "full", "1 cm"}, "cases/a", "", ""});
  sweep.cases.push_back({{"30 deg", "0.5, \"x\"", "10 mm"}, "cases/b", "", ""});
  const Table table = sweep_table(sweep, {not_run, disk_full}, "sandsim sweep");
  const std::string csv = csv_text(table);
  CHECK(contains(csv, "case,a [deg],b,c,status,exit_code,message,folder\n"));
  CHECK(contains(csv, "1,20,full,1 cm,,0,,cases/a\n"));
  CHECK(contains(csv, "2,30,\"0.5, \"\"x\"\"\",10 mm,,6,,cases/b\n"));
}

TEST_CASE("the counts of a sweep name only what there is") {
  CHECK(counts_line({4, 4, 0, 0, 0}, "waiting") == "4 of 4 done");
  CHECK(counts_line({64, 12, 1, 0, 2}, "waiting") == "12 of 64 done, 1 failed, 2 running, 49 waiting");
  CHECK(counts_line({3, 1, 0, 1, 0}, "not run") == "1 of 3 done, 1 interrupted, 1 not run");
}
