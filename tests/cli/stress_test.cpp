// `sandsim stress`: each criterion catches what it is for, a crash stays in its case, and the quick part passes.
#include <unistd.h>

#include <csignal>
#include <limits>
#include <map>
#include <set>

#include "cli/stress/case_raster.hpp"
#include "cli/stress/criteria.hpp"
#include "cli/stress/isolated_jobs.hpp"
#include "cli/stress/matrix.hpp"
#include "cli/stress/measure.hpp"
#include "cli/stress/stress_files.hpp"
#include "cli/stress/stress_table.hpp"
#include "io/scene/scene_reader.hpp"
#include "solver/errors.hpp"
#include "support.hpp"
#include "tests/support/catch.hpp"

namespace sandsim::cli {
namespace {

using test::call;
using test::contains;
using test::Outcome;
using test::Process;
using test::read_text;
using test::TemporaryDirectory;
using test::write_text;

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Of a run that satisfies the criteria: 2 E at 0.1 dx/E.
Measurement good_run() {
  Measurement run;
  run.steps = 100;
  run.volume_error = 1e-14;
  run.max_speed = 6.0;
  run.energy_speed = 3.0;
  run.spacing = 0.3;
  run.dt_min = 0.01;
  run.is_unchanged = run.at_rest = true;
  return run;
}

/// "volume, speed": the criteria that a run fails.
std::string failed(const Measurement& run, const Criteria& criteria = {}, Precision precision = Precision::float32) {
  StressRow row;
  row.findings = judge(run, criteria, precision);
  return row.failed_criteria();
}

// ---- criteria -------------------------------------------------------------------------------------------------------

TEST_CASE("a run that satisfies every criterion has no findings") {
  Criteria all;
  all.rest_kept = all.stops = true;
  CHECK(failed(good_run(), all).empty());
  CHECK(failed(good_run(), all, Precision::float64).empty());
}

TEST_CASE("each criterion catches its failure and no other") {
  const auto broken = [](auto change) {
    Measurement run = good_run();
    change(run);
    return run;
  };
  CHECK(failed(broken([](Measurement& run) { run.is_finite = false; })) == "finite");
  CHECK(failed(broken([](Measurement& run) { run.is_positive = false; })) == "depth");
  CHECK(failed(broken([](Measurement& run) { run.is_repeated = false; })) == "repeat");
  CHECK(failed(broken([](Measurement& run) { run.volume_error = -2.1e-6; })) == "volume");
  CHECK(failed(broken([](Measurement& run) { run.max_speed = 15.1; })) == "speed");
  CHECK(failed(broken([](Measurement& run) { run.dt_min = 0.0014; })) == "step");
  CHECK(failed(broken([](Measurement& run) { run.exit_code = 5; })) == "ending");
}

TEST_CASE("the bound of the volume goes with the precision") {
  Measurement run = good_run();
  run.volume_error = 1e-12;
  CHECK(failed(run, {}, Precision::float32).empty());
  CHECK(failed(run, {}, Precision::float64) == "volume");
}

TEST_CASE("sand that has to stay at rest or come to rest is judged for it only where the case says so") {
  Measurement run = good_run();
  run.is_unchanged = run.at_rest = false;
  CHECK(failed(run).empty());
  Criteria rest;
  rest.rest_kept = true;
  CHECK(failed(run, rest) == "rest");
  Criteria stop;
  stop.stops = true;
  CHECK(failed(run, stop) == "stops");
  run.at_rest = true;
  CHECK(failed(run, stop).empty());
  run.slope_violation = 0.021;
  CHECK(failed(run, stop) == "stops");
}

TEST_CASE("a run that must be refused has to say why") {
  Criteria refused;
  refused.ending = ExitCode::numerical_failure;
  refused.message = "stability bound";
  Measurement run;
  run.exit_code = 5;
  run.message = "time.step is longer than the stability bound";
  CHECK(failed(run, refused).empty());
  run.message = "numerical failure: depth is not finite";
  CHECK(failed(run, refused) == "ending");
  CHECK(failed(good_run(), refused) == "ending");
}

TEST_CASE("sand that moves though it has no energy is too fast") {
  Measurement run = good_run();
  run.energy_speed = 0.0;
  CHECK(failed(run) == "speed");
  run.max_speed = 0.0;
  CHECK(failed(run).empty());
}

TEST_CASE("a measurement survives the way from process to process") {
  Measurement run = good_run();
  run.message = "line one\n  and 2 spaces";
  run.volume_error = -1.0 / 3.0;
  run.dt_min = infinite;
  run.steps = 12345678901;
  run.exit_code = 130;
  run.slope_violation = 0.5;
  const Measurement back = Measurement::decode(run.encode());
  CHECK(back.message == run.message);
  CHECK(back.volume_error == run.volume_error);
  CHECK(back.dt_min == infinite);
  CHECK(back.steps == run.steps);
  CHECK(back.exit_code == 130);
  CHECK(back.slope_violation == 0.5);
  CHECK(back.is_finite);
  CHECK(back.is_unchanged);
  CHECK(Measurement::decode(Measurement{}.encode()).message.empty());
}

// ---- measuring ------------------------------------------------------------------------------------------------------

/// The findings of a case with a scheme in float64, by measuring it.
std::string measured(const StressCase& its, const Variant& variant) {
  const TemporaryDirectory folder;
  const Trial trial{write_case(its, folder.path()), variant, its.criteria, its.step_in_bounds};
  return failed(measure(trial, {}), its.criteria, variant.precision);
}

const Variant balanced{"balanced", 2, Precision::float64};
const Variant paper{"paper", 0, Precision::float64};

TEST_CASE("the paper's scheme is caught moving a lake that the balanced one keeps") {
  StressCase lake{"lake", "a lake on an uneven bed", {}};
  lake.scene.grid = "{cells: [16, 1], spacing: 1 cm}";
  lake.scene.friction = "friction_angle: 0 deg";
  lake.scene.terrain = "{type: raster, file: bed.npy}";
  lake.scene.initial = "{type: layer, surface: 3 cm}";
  lake.rasters = {make_noise("bed.npy", 16, 1, 0.05, 1)};
  lake.criteria.rest_kept = true;
  CHECK(measured(lake, balanced).empty());
  CHECK(measured(lake, paper) == "rest");
}

TEST_CASE("measured runs are caught breaking bounds that are too narrow for them") {
  StressCase dam{"dam", "a dam", {}};
  CHECK(measured(dam, balanced).empty());
  StressCase changed = dam;
  changed.criteria.speed = 0.5;
  CHECK(measured(changed, balanced) == "speed");
  changed = dam;
  changed.criteria.step = 10.0;
  CHECK(measured(changed, balanced) == "step");
  changed = dam;
  changed.criteria.rest_kept = true;
  CHECK(measured(changed, balanced) == "rest");
  changed = dam;
  changed.criteria.stops = true;
  changed.scene.end = 0.05;
  CHECK(measured(changed, balanced) == "stops");
}

TEST_CASE("fixed steps are taken in bounds of the scheme") {
  StressCase dam{"dam", "a dam in long steps", {}};
  dam.step_in_bounds = 2.0;
  CHECK(measured(dam, balanced) == "ending");
  dam.criteria.ending = ExitCode::numerical_failure;
  dam.criteria.message = "longer than the stability bound";
  CHECK(measured(dam, balanced).empty());
  CHECK(measured(dam, paper).empty());
}

TEST_CASE("a scene that is none ends as the command would") {
  const TemporaryDirectory folder;
  write_text(folder / "bad.yaml", "grid: {}\n");
  const Measurement run = measure({folder / "bad.yaml", balanced, {}, 0.0}, {});
  CHECK(run.exit_code == 2);
  CHECK(contains(run.message, "grid.cells"));
}

// ---- isolated jobs --------------------------------------------------------------------------------------------------

/// The ends of the jobs, by their numbers.
std::map<std::size_t, JobEnd> ends_of(std::size_t count, int workers, double limit,
                                      const std::function<std::string(std::size_t)>& job) {
  std::map<std::size_t, JobEnd> ends;
  run_isolated(count, workers, limit, job,
               [&](std::size_t k, const JobEnd& end) { CHECK(ends.emplace(k, end).second); });
  return ends;
}

TEST_CASE("every job's result comes back, however long it is") {
  const auto ends = ends_of(50, 3, 60.0, [](std::size_t k) { return std::string(k * 5000, 'x'); });
  REQUIRE(ends.size() == 50);
  for (const auto& [k, end] : ends) {
    CHECK(end.problem.empty());
    CHECK(end.result.size() == k * 5000);
  }
  CHECK(ends_of(0, 2, 60.0, [](std::size_t) { return ""; }).empty());
}

TEST_CASE("a job that crashes exits or hangs is its own end and stops no other") {
  const auto ends = ends_of(9, 2, 0.5, [](std::size_t k) -> std::string {
    if (k == 2) {
      raise(SIGKILL);
    } else if (k == 4) {
      _exit(3);
    } else if (k == 6) {
      sleep(1000);
    }
    return "done";
  });
  REQUIRE(ends.size() == 9);
  CHECK(contains(ends.at(2).problem, "killed by signal 9"));
  CHECK(ends.at(4).problem == "ended with exit code 3");
  CHECK(ends.at(6).problem == "no answer in 0.5 s");
  for (const std::size_t k : {0, 1, 3, 5, 7, 8}) {
    CHECK(ends.at(k).problem.empty());
    CHECK(ends.at(k).result == "done");
  }
}

// ---- the matrix -----------------------------------------------------------------------------------------------------

TEST_CASE("every case of the matrix is a scene of its own that is read, or refused as it has to be") {
  const TemporaryDirectory folder;
  std::set<std::string> names;
  std::vector<StressCase> cases = stress_matrix();
  CHECK(cases.size() >= 150);
  for (const StressCase& cell : stability_maps()) {
    cases.push_back(cell);
  }
  for (const StressCase& its : cases) {
    CAPTURE(its.name);
    CHECK(names.insert(its.name).second);
    CHECK_FALSE(its.meaning.empty());
    CHECK_FALSE(its.theme.empty());
    std::string problem;
    try {
      read_scene(write_case(its, folder.path()), balanced.overrides());
    } catch (const Error& error) {
      problem = error.what();
      CHECK(error.code() == its.criteria.ending);
      CHECK(contains(problem, its.criteria.message));
    }
    CHECK((its.criteria.ending == ExitCode::invalid_scene) == !problem.empty());
  }
}

TEST_CASE("the quick part has some of every theme and the corners of every map") {
  std::set<std::string> themes, quick_themes;
  for (const StressCase& its : stress_matrix()) {
    themes.insert(its.theme);
  }
  const std::vector<StressCase> quick = quick_part(stress_matrix());
  for (const StressCase& its : quick) {
    quick_themes.insert(its.theme);
  }
  CHECK(quick_themes == themes);
  CHECK(quick.size() < stress_matrix().size() / 6);
  CHECK(quick_part(stability_maps()).size() == 18);  // three by three of each
}

// ---- the command ----------------------------------------------------------------------------------------------------

TEST_CASE("stress --quick passes with every scheme and writes its tables and scenes") {
  const TemporaryDirectory folder;
  const test::TemporaryDirectory process_folder;
  const std::string directory = (folder / "out").string();
  const Outcome outcome = Process({"stress", "--quick", "-o", directory}, process_folder.path()).wait();
  INFO(outcome.out << outcome.err);
  CHECK(outcome.code == 0);
  CHECK(contains(outcome.out, "balanced order 2  float64"));
  CHECK_FALSE(contains(outcome.out, "FAILED  "));
  const std::string csv = read_text(folder / "out/stress.csv");
  CHECK(contains(csv, "theme,case,scheme,order,precision,device,verdict"));
  CHECK(contains(csv, "balanced,2,float32,cpu,pass"));
  CHECK(contains(read_text(folder / "out/maps.csv"), "courant_friction,0.05,0,balanced,1,float64,cpu,pass"));
  CHECK(contains(read_text(folder / "out/stress.md"), "| friction_dam_0deg | pass |"));
  CHECK(call({"check", (folder / "out/scenes/friction_dam_0deg.yaml").string()}).code == 0);
}

TEST_CASE("stress judges given scenes, and a failure exits 5 and leaves a scene that reproduces it") {
  const TemporaryDirectory folder;
  const TemporaryDirectory process_folder;
  write_text(folder / "good.yaml", test::small_scene());
  const std::string directory = (folder / "out").string(), good = (folder / "good.yaml").string();
  CHECK(Process({"stress", good, "-o", directory}, process_folder.path()).wait().code == 0);
  CHECK(contains(read_text(folder / "out/stress.csv"), "given,good,paper,1,float32"));
  // A step below time.minimum_step stops the run.
  write_text(folder / "broken.yaml", test::small_scene());
  const std::string text = test::small_scene();
  const std::size_t at = text.find("end:");
  REQUIRE(at != std::string::npos);
  write_text(folder / "broken.yaml", text.substr(0, at) + "minimum_step: 10 ms, " + text.substr(at));
  const Outcome outcome =
      Process({"stress", (folder / "broken.yaml").string(), "-o", directory, "--overwrite"}, process_folder.path())
          .wait();
  CHECK(outcome.code == 5);
  CHECK(contains(outcome.out, "below time.minimum_step"));
  const std::string scene = (folder / "out/failures/broken_balanced2_float64.yaml").string();
  CHECK(contains(read_text(scene), "# - ending: exit code 5"));
  CHECK(call({"run", scene, "-o", (folder / "again").string(), "-q"}).code == 5);
}

TEST_CASE("stress refuses what it cannot do") {
  const TemporaryDirectory folder;
  const std::string directory = (folder / "out").string();
  write_text(folder / "full/file", "mine");
  const Outcome full = call({"stress", "--quick", "-o", (folder / "full").string()});
  CHECK(full.code == 6);
  CHECK(contains(full.err, "--overwrite"));
  CHECK(call({"stress", (folder / "missing.yaml").string(), "-o", directory}).code == 3);
  CHECK(call({"stress", "--only", "no such case", "-o", directory, "--overwrite"}).code == 1);
  CHECK(call({"stress", "--device", "abacus"}).code == 1);
}

}  // namespace
}  // namespace sandsim::cli
