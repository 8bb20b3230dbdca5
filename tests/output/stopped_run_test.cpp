// A run that is stopped and goes on from its checkpoint has the bits of one that was never stopped, wherever that is:
// here after every single step. What a step needs is then the state alone, and all of it is in the checkpoint.

#include <array>
#include <atomic>
#include <cstring>
#include <optional>

#include "io/output/checkpoint.hpp"
#include "solver/simulation.hpp"
#include "tests/output/fixtures.hpp"
#include "tests/solver/support.hpp"
#include "tests/support/catch.hpp"

namespace sandsim::test {
namespace {

/// A thin stream at 2 m/s down a periodic grid, 24 x 10 cells of 2.5 cm: what falls or lies into it slows its fastest
/// cells.
Scene stream(Precision precision) {
  Scene scene = collapse(24, 10, precision);
  scene.sand.friction_coefficient = 0.2;
  SandColumn column;
  column.center = {0.3, 0.125}, column.radius = 0.11;
  column.fill.depth = 0.004, column.velocity = {2.0, 0.3};
  scene.sand.initial = {column};
  scene.boundaries.x_min = scene.boundaries.x_max = BoundaryKind::periodic;
  scene.boundaries.y_min = BoundaryKind::open;
  scene.output.fields = {OutputField::depth, OutputField::velocity, OutputField::momentum, OutputField::surface};
  scene.output.maxima.emplace();
  scene.particles = Particles{};
  scene.particles->spacing = 0.5 * scene.grid.spacing;
  scene.time.end = 0.2, scene.time.frame_interval = 0.02;
  return scene;
}

/// A block across the stream that goes against it and meets its front; one that drags appears all over it.
KinematicObject block(Coupling coupling) {
  KinematicObject block;
  block.name = "block";
  block.shape = BoxShape{{coupling == Coupling::drag ? 0.7 : 0.1, 0.3, 0.2}, {}};
  block.position = {coupling == Coupling::drag ? 0.3 : 0.5, 0.125, 0.1};
  block.motion = ConstantMotion{{-0.3, 0.0, 0.0}, {}};
  block.coupling = coupling;
  block.start = 0.03, block.end = 0.15;
  return block;
}

std::vector<Scene> scenes(Precision precision) {
  Scene rain = stream(precision);
  rain.sand.sources = {{{0.3, 0.125}, 0.2, 2e-3, 0.0, 0.15}, {{0.5, 0.1}, 0.05, 1e-4, 0.05, 0.3}};
  std::vector<Scene> all{rain};
  for (const Coupling coupling : {Coupling::drag, Coupling::displace, Coupling::solid}) {
    Scene body = stream(precision);
    body.objects = {block(coupling)};
    all.push_back(body);
  }
  Scene both = rain;
  both.sand.friction_coefficient = 0.6;
  both.objects = {block(Coupling::displace)};
  both.terrain = {PlaneTerrain{0.2, {}}};
  all.push_back(both);
  return all;
}

bool same_bits(const FieldValues& a, const FieldValues& b) {
  return std::visit(
      [&](const auto& left) {
        const auto* right = std::get_if<std::remove_cvref_t<decltype(left)>>(&b);
        return right != nullptr && left.size() == right->size() &&
               (left.empty() || std::memcmp(left.data(), right->data(), left.size() * sizeof(left[0])) == 0);
      },
      a);
}

void check_same_frames(const MemorySink& stopped, const MemorySink& whole) {
  REQUIRE(stopped.frames.size() == whole.frames.size());
  for (std::size_t k = 0; k < whole.frames.size(); ++k) {
    CAPTURE(k);
    const Frame &a = stopped.frames[k], &b = whole.frames[k];
    REQUIRE(a.fields.size() == b.fields.size());
    for (std::size_t f = 0; f < b.fields.size(); ++f) {
      CAPTURE(b.fields[f].name);
      CHECK(same_bits(a.fields[f].values, b.fields[f].values));
    }
    const FrameStatistics &p = a.statistics, &q = b.statistics;
    CHECK((p.time == q.time && p.steps == q.steps && p.volume == q.volume && p.kinetic_energy == q.kinetic_energy));
    CHECK((p.time_step_min == q.time_step_min && p.time_step_max == q.time_step_max && p.max_speed == q.max_speed));
    CHECK((a.particles.position == b.particles.position && a.particles.id == b.particles.id));
  }
  CHECK(same_bits(stopped.finals.max_depth, whole.finals.max_depth));
  CHECK(same_bits(stopped.finals.max_speed, whole.finals.max_speed));
  CHECK(same_bits(stopped.finals.arrival_time, whole.finals.arrival_time));
}

TEST_CASE("A run that is stopped after every step has the bits of one that is not") {
  const TemporaryDirectory folder;
  for (const Precision precision : {Precision::float32, Precision::float64}) {
    for (const Scheme scheme : {Scheme::balanced, Scheme::paper}) {
      std::size_t number = 0;
      for (Scene& scene : scenes(precision)) {
        CAPTURE(static_cast<int>(precision), static_cast<int>(scheme), number);
        number += 1;
        scene.numerics.scheme = scheme;
        MemorySink whole, stopped;
        const RunReport expected = run(scene, {}, whole);
        REQUIRE(expected.status == "done");

        const std::atomic<bool> interrupt = true;  // a run looks at it after its first step
        std::optional<Checkpoint> kept;
        RunOptions options;
        options.interrupt = &interrupt;
        options.checkpoint = [&](const Checkpoint& checkpoint) {
          write_checkpoint(folder / "checkpoint.h5", checkpoint, "this scene");
        };
        RunReport report = run(scene, options, stopped);
        std::int64_t stops = 0;
        while (report.status == "interrupted") {
          kept = read_checkpoint(folder / "checkpoint.h5", "this scene");
          options.resume = &*kept;
          report = run(scene, options, stopped);
          ++stops;
        }
        CHECK(report.status == "done");
        CHECK(stops >= expected.steps - 1);
        CHECK(report.steps == expected.steps);
        CHECK((report.dt_min == expected.dt_min && report.dt_max == expected.dt_max));
        CHECK((report.ledger.in == expected.ledger.in && report.ledger.out == expected.ledger.out));
        CHECK(report.ledger.final == expected.ledger.final);
        check_same_frames(stopped, whole);
      }
    }
  }
}

}  // namespace
}  // namespace sandsim::test
