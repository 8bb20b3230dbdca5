#include "solver/simulation.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>

#include "solver/needs.hpp"
#include "tests/solver/support.hpp"
#include "tests/support/catch.hpp"

namespace sandsim::test {
namespace {

std::vector<std::string> names(const RunReport& report) {
  std::vector<std::string> out;
  for (const StageReport& stage : report.stages) {
    out.push_back(stage.name);
  }
  return out;
}

TEST_CASE("Adaptive steps land on the frames exactly") {
  MemorySink sink;
  const RunReport report = run(collapse(40, 1, Precision::float64), {}, sink);
  CHECK(report.status == "done");
  REQUIRE(sink.frames.size() == 11);
  for (std::size_t k = 0; k < 10; ++k) {
    CHECK(sink.frames[k].statistics.time == static_cast<double>(k) * 0.1);
  }
  CHECK(sink.frames[10].statistics.time == 1.0);
  CHECK(sink.begun == 1);
  CHECK(sink.ended == 1);
}

TEST_CASE("Sand starts with the velocity that the scene gives it, and crosses a periodic grid") {
  for (const Scheme scheme : {Scheme::balanced, Scheme::paper}) {
    Scene scene = collapse(40, 8, Precision::float32);
    scene.sand.friction_coefficient = 0.0;
    scene.sand.initial = {SandLayer{{0.25, {}}, {1.5, -0.5}}};
    scene.boundaries = {BoundaryKind::periodic, BoundaryKind::periodic, BoundaryKind::periodic, BoundaryKind::periodic};
    scene.numerics.scheme = scheme;
    scene.numerics.velocity = VelocityForm::quotient;
    MemorySink sink;
    const RunReport report = run(scene, {}, sink);
    CHECK(report.status == "done");
    for (const Frame& frame : {sink.frames.front(), sink.frames.back()}) {
      // Uniform sand without friction goes on for ever: every flux difference is an exact zero.
      CHECK(std::get<std::vector<float>>(field_of(frame, "velocity_x")) == std::vector<float>(320, 1.5F));
      CHECK(std::get<std::vector<float>>(field_of(frame, "velocity_y")) == std::vector<float>(320, -0.5F));
    }
  }
}

TEST_CASE("A plan counts on the velocity of the sand") {
  Scene scene = collapse(40, 1, Precision::float64);
  const double at_rest = plan(scene).first_step;
  std::get<SandBox>(scene.sand.initial[0]).velocity = {100.0, 0.0};
  CHECK(plan(scene).first_step < 0.02 * at_rest);
}

TEST_CASE("A fixed step is taken as often as it fits") {
  Scene scene = collapse(40, 1, Precision::float32);
  scene.time.mode = TimeMode::fixed;
  scene.time.step = 0.002;  // the bound of this scene at its fastest is 3 ms
  MemorySink sink;
  const RunReport report = run(scene, {}, sink);
  CHECK(report.status == "done");
  CHECK(report.dt_min == 0.002);
  CHECK(report.dt_max == 0.002);
  // Nothing moves any more before the end: the last frames need no steps.
  CHECK(sink.frames[3].statistics.steps == 150);
}

TEST_CASE("A fixed step over the stability bound stops the run and names cell and bound") {
  Scene scene = collapse(40, 1, Precision::float32);
  scene.time.mode = TimeMode::fixed;
  scene.time.step = 0.02;
  scene.time.frame_interval = 0.1;
  MemorySink sink;
  const RunReport report = run(scene, {}, sink);
  CHECK(report.exit_code == ExitCode::numerical_failure);
  REQUIRE(report.failure);
  CHECK(report.failure->i >= 0);
  CHECK(report.failure->cause == "the fixed step breaks the stability bound");
  CHECK(report.message.find("stability bound") != std::string::npos);
  CHECK(report.message.find("subcycle") != std::string::npos);
  CHECK(sink.frames.size() == 1);  // the initial state was handed out and nothing pretends to be more
  CHECK(sink.ended == 0);
}

TEST_CASE("Subcycles keep a long fixed step stable and its times") {
  Scene scene = collapse(40, 1, Precision::float64);
  scene.time.mode = TimeMode::fixed;
  scene.time.step = 0.02;
  scene.time.subcycle = true;
  MemorySink sink;
  const RunReport report = run(scene, {}, sink);
  CHECK(report.status == "done");
  CHECK(report.dt_max <= 0.02);
  CHECK(report.steps > 20);
  CHECK(sink.frames.back().statistics.time == 1.0);
}

TEST_CASE("A run stops at rest with every momentum zero and no face steeper than friction holds") {
  for (const Precision precision : {Precision::float32, Precision::float64}) {
    Scene scene = collapse(60, 1, precision);
    scene.output.fields = {OutputField::depth, OutputField::momentum};
    scene.time.end = 10.0;
    scene.time.stop_at_rest = true;
    MemorySink sink;
    const RunReport report = run(scene, {}, sink);
    CHECK(report.status == "at rest");
    CHECK(report.at_rest);
    CHECK(report.simulated_time < 2.0);
    CHECK(report.stop_time <= report.simulated_time);
    CHECK(report.max_slope_violation <= 1e-5);  // the quantum of a float32 depth of 0.2 m is 1e-6 of mu dx
    std::visit([](const auto& q) { CHECK(std::all_of(q.begin(), q.end(), [](auto v) { return v == 0; })); },
               field_of(sink.frames.back(), "momentum_x"));
    CHECK(sink.frames.back().statistics.moving_cells == 0);
  }
}

TEST_CASE("After rest the frames repeat without a step") {
  Scene scene = collapse(60, 1, Precision::float32);
  scene.time.end = 6.0;
  MemorySink sink;
  const RunReport report = run(scene, {}, sink);
  CHECK(report.status == "done");
  CHECK(report.at_rest);
  REQUIRE(sink.frames.size() == 61);
  CHECK(sink.frames[60].statistics.steps == sink.frames[50].statistics.steps);
  CHECK(field_of(sink.frames[60], "depth") == field_of(sink.frames[50], "depth"));
}

TEST_CASE("A resumed run gives the bits of an uninterrupted one") {
  for (const Precision precision : {Precision::float32, Precision::float64}) {
    Scene scene = collapse(40, 9, precision);
    scene.output.maxima.emplace();
    scene.sand.sources = {{{0.8, 0.1}, 0.05, 0.002, 0.05, 0.6}};
    KinematicObject plough;  // it covers sand when the run is interrupted
    plough.name = "plough";
    plough.shape = SphereShape{0.1, {}};
    plough.position = {0.1, 0.1, 0.12};
    plough.motion = ConstantMotion{{0.2, 0.0, 0.0}, {}};
    scene.objects = {plough};
    scene.particles = Particles{};
    scene.particles->spacing = 0.5 * scene.grid.spacing;
    MemorySink whole, first, second;
    const RunReport expected = run(scene, {}, whole);

    std::atomic<bool> interrupt = false;
    std::optional<Checkpoint> kept;
    RunOptions options;
    options.interrupt = &interrupt;
    options.progress = [&](const Progress& progress) { interrupt = progress.steps >= 57; };
    options.checkpoint = [&](const Checkpoint& checkpoint) { kept = checkpoint; };
    const RunReport stopped = run(scene, options, first);
    CHECK(stopped.status == "interrupted");
    CHECK(stopped.exit_code == ExitCode::interrupted);
    CHECK(first.ended == 0);
    REQUIRE(kept);
    const auto& buried = std::get<std::vector<double>>(kept->state.buried);
    CHECK(std::any_of(buried.begin(), buried.end(), [](double depth) { return depth > 0.0; }));

    RunOptions rest;
    rest.resume = &*kept;
    const RunReport resumed = run(scene, rest, second);
    CHECK(resumed.steps == expected.steps);
    CHECK(resumed.ledger.final == expected.ledger.final);
    CHECK(resumed.ledger.in == expected.ledger.in);
    CHECK(resumed.dt_min == expected.dt_min);
    REQUIRE(first.frames.size() + second.frames.size() == whole.frames.size());
    CHECK(second.frames.back().statistics.time == whole.frames.back().statistics.time);
    CHECK(second.frames.front().statistics.time_step_min == whole.frames[first.frames.size()].statistics.time_step_min);
    for (const char* name : {"depth", "velocity_x", "velocity_y"}) {
      CHECK(field_of(second.frames.back(), name) == field_of(whole.frames.back(), name));
    }
    CHECK(second.finals.max_speed == whole.finals.max_speed);
    CHECK(second.finals.max_depth == whole.finals.max_depth);
    CHECK(second.frames.back().particles.id == whole.frames.back().particles.id);
    CHECK(second.frames.back().particles.position == whole.frames.back().particles.position);
    CHECK(second.frames.back().objects.front().position == whole.frames.back().objects.front().position);
    REQUIRE(resumed.particles);
    CHECK(resumed.particles->born == expected.particles->born);
    CHECK(resumed.particles->moves == expected.particles->moves);
  }
}

TEST_CASE("Particles do not act on the sand, and without them there is no trace of them") {
  Scene scene = collapse(40, 9, Precision::float32);
  MemorySink without, with;
  const RunReport bare = run(scene, {}, without);
  scene.particles = Particles{};
  scene.particles->spacing = scene.grid.spacing;
  const RunReport report = run(scene, {}, with);
  CHECK(report.steps == bare.steps);
  REQUIRE(with.frames.size() == without.frames.size());
  for (std::size_t k = 0; k < with.frames.size(); ++k) {
    CHECK(field_of(with.frames[k], "depth") == field_of(without.frames[k], "depth"));
    CHECK(with.frames[k].particles.id.size() == 360);
    CHECK(without.frames[k].particles.id.empty());
  }
  CHECK_FALSE(bare.particles);
  CHECK(bare.memory_bytes < report.memory_bytes);
  const auto has_stage = [](const RunReport& of) {
    return std::any_of(of.stages.begin(), of.stages.end(), [](const auto& stage) { return stage.name == "particles"; });
  };
  CHECK_FALSE(has_stage(bare));
  CHECK(has_stage(report));
  // The sand runs along x only, and takes some with it.
  REQUIRE(report.particles);
  CHECK(report.particles->moves > 0);
  CHECK(report.particles->born == report.particles->merged);
}

TEST_CASE("Frames say where the objects are and whether they are there") {
  Scene scene = collapse(20, 20, Precision::float32);
  KinematicObject sphere;
  sphere.name = "sphere";
  sphere.shape = SphereShape{0.05, {}};
  sphere.position = {0.1, 0.2, 0.5};
  sphere.motion = ConstantMotion{{0.1, 0.0, 0.0}, {0.0, 0.0, M_PI}};
  sphere.start = 0.2, sphere.end = 0.8;
  scene.objects = {sphere};
  MemorySink sink;
  run(scene, {}, sink);
  REQUIRE(sink.frames.size() == 11);
  REQUIRE(sink.frames[7].objects.size() == 1);
  const ObjectPose& pose = sink.frames[7].objects[0];  // at 0.7 s, half a second after the start
  CHECK_THAT(pose.position[0], WithinAbs(0.15, 1e-12));
  CHECK_THAT(pose.rotation[0], WithinAbs(std::sqrt(0.5), 1e-12));  // a quarter turn
  CHECK_THAT(pose.rotation[3], WithinAbs(std::sqrt(0.5), 1e-12));
  CHECK(pose.present);
  CHECK_FALSE(sink.frames[1].objects[0].present);
  CHECK_FALSE(sink.frames[9].objects[0].present);
}

TEST_CASE("A wall clock limit ends the run with a checkpoint") {
  RunOptions options;
  int checkpoints = 0;
  options.max_wall = 1e-9;
  options.checkpoint = [&](const Checkpoint&) { checkpoints += 1; };
  MemorySink sink;
  const RunReport report = run(collapse(40, 1, Precision::float32), options, sink);
  CHECK(report.exit_code == ExitCode::wall_clock_limit);
  CHECK(report.steps == 1);
  CHECK(checkpoints == 1);
}

TEST_CASE("A collapsing step stops the run with its cell") {
  Scene scene = collapse(40, 1, Precision::float32);
  scene.time.minimum_step = 0.5;
  MemorySink sink;
  const RunReport report = run(scene, {}, sink);
  CHECK(report.exit_code == ExitCode::numerical_failure);
  REQUIRE(report.failure);
  CHECK(report.failure->cause == "the time step collapsed");
  CHECK(report.failure->i >= 0);
}

TEST_CASE("Short steps in a long run are no collapse") {
  Scene scene = collapse(40, 1, Precision::float32);
  SandLayer layer;
  layer.fill.depth = 0.1;
  scene.sand.initial = {layer};
  scene.time.end = 1e8;  // 1e-9 of it is ten stable steps
  scene.time.frame_interval = 1e7;
  MemorySink sink;
  const RunReport report = run(scene, {}, sink);
  CHECK(report.status == "done");
  CHECK(report.at_rest);
}

TEST_CASE("A source brings what its rate promises onto a dry bed") {
  Scene scene = collapse(41, 41, Precision::float64);
  scene.sand.initial.clear();
  scene.sand.sources = {{{0.5125, 0.5125}, 0.06, 0.003, 0.1, 0.7}};
  MemorySink sink;
  const RunReport report = run(scene, {}, sink);
  CHECK(report.status == "done");
  CHECK_THAT(report.ledger.in, WithinRel(0.003 * 0.6, 1e-12));  // sums of about 1e3 rounded additions
  CHECK_THAT(report.ledger.final, WithinRel(0.003 * 0.6, 1e-12));
  CHECK(std::fabs(report.ledger.error()) <= 1e-13);
  CHECK(report.dt_max <= std::sqrt(0.025 / 9.8));
}

TEST_CASE("A run has the stages that its scene needs and no other") {
  MemorySink sink;
  Scene scene = collapse(20, 1, Precision::float32);
  scene.output.fields = {OutputField::depth};
  const RunReport plain = run(scene, {}, sink);
  CHECK(names(plain) == std::vector<std::string>{"step", "frames"});
  // A flat 1-D scene moves its state in and out and nothing else: six words a cell and step.
  CHECK(plain.stages[0].bytes == 6.0 * 4.0 * 20.0 * static_cast<double>(plain.stages[0].launches));
  CHECK(plain.stages[1].bytes == 4.0 * 20.0 * 11.0);

  scene.output.maxima.emplace();
  scene.output.frames = false;
  scene.sand.sources = {{{0.3, 0.0}, 0.01, 0.001, 0.0, 0.1}};
  const RunReport rich = run(scene, {}, sink);
  CHECK(names(rich) == std::vector<std::string>{"step", "sources", "maxima", "frames"});
  CHECK(rich.stages[3].bytes == 0.0);
  CHECK(rich.memory_bytes > plain.memory_bytes);
}

TEST_CASE("The needs of a scene are those of its run") {
  Scene scene = collapse(40, 10, Precision::float32);
  CHECK(needs_of(scene).frames == 11);
  CHECK(needs_of(scene).output_bytes == 11 * (3 * 400 * 4 + 72));
  scene.grid.cells = {400, 300};
  for (const bool rich : {false, true}) {
    if (rich) {
      scene.output.maxima.emplace();
      scene.terrain = {PlaneTerrain{0.1, 0.0, 0.0}};
      scene.particles = Particles{};
      scene.particles->spacing = 0.5 * scene.grid.spacing;
    }
    MemorySink sink;
    const auto memory = static_cast<double>(run(scene, {}, sink).memory_bytes);
    // The run also counts halos and the rows that are under way, a fifth of so small a grid; but not the ids in a
    // frame of particles, 8 of 85 bytes.
    CHECK(needs_of(scene).state_bytes <= 1.1 * memory);
    CHECK(needs_of(scene).state_bytes >= 0.8 * memory);
  }
}

TEST_CASE("A plan predicts the steps of the run") {
  const Plan predicted = plan(collapse(40, 10, Precision::float32));
  CHECK(predicted.first_step > 0.0);
  CHECK(predicted.predicted_steps > 0);
}

TEST_CASE("Probes hand out the cell that holds them") {
  Scene scene = collapse(40, 1, Precision::float32);
  scene.output.probes = {{"inside", {0.01, 0.0}}, {"far", {0.99, 0.0}}};
  MemorySink sink;
  run(scene, {}, sink);
  CHECK(sink.frames.front().probes[0].depth == static_cast<double>(0.2f));
  CHECK(sink.frames.front().probes[1].depth == 0.0);
}

}  // namespace
}  // namespace sandsim::test
