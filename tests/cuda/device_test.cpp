#include <atomic>
#include <optional>

#include "solver/backends/cuda/cuda.hpp"
#include "solver/errors.hpp"
#include "solver/simulation.hpp"
#include "tests/cuda/physics_on_device.hpp"
#include "tests/solver/support.hpp"
#include "tests/support/catch.hpp"
#include "tests/tiles/parity.hpp"

namespace sandsim::test {
namespace {

TEST_CASE("The laws give the same bits on the device") {
  CHECK(count_cells_that_differ() == 0);
}

TEST_CASE("A step on the device gives the bits of the CPU backend") {
  check_steps(make_cuda_backend);
}

TEST_CASE("A loop of steps with sources and maxima on the device goes as on the CPU") {
  check_loops(make_cuda_backend);
}

TEST_CASE("The state alone bounds the next step on the device") {
  check_bounds(make_cuda_backend);
}

TEST_CASE("Objects act on the device as on the CPU") {
  check_objects_on(make_cuda_backend);
}

TEST_CASE("Particles on the device are those of the CPU") {
  check_particles_on(make_cuda_backend);
}

TEST_CASE("Runs side by side on the device go as each on the CPU") {
  check_ensemble(make_cuda_ensemble);
}

TEST_CASE("A run on the device hands out the frames of a run on the CPU") {
  for (const Precision precision : {Precision::float32, Precision::float64}) {
    Scene scene = collapse(300, 70, precision);
    scene.output.maxima.emplace();
    scene.sand.sources = {{{3.0, 0.5}, 0.2, 0.002, 0.05, 0.6}};
    MemorySink on_cpu, on_device;
    RunOptions cpu, cuda;
    cuda.device = Device::cuda;
    const RunReport a = run(scene, cpu, on_cpu), b = run(scene, cuda, on_device);
    CHECK(a.steps == b.steps);
    CHECK((a.dt_min == b.dt_min && a.dt_max == b.dt_max));
    CHECK(a.ledger.final == b.ledger.final);
    CHECK(a.max_slope_violation == b.max_slope_violation);
    REQUIRE(a.smallest_step);
    REQUIRE(b.smallest_step);
    CHECK((a.smallest_step->i == b.smallest_step->i && a.smallest_step->j == b.smallest_step->j));
    REQUIRE(on_cpu.frames.size() == on_device.frames.size());
    for (std::size_t k = 0; k < on_cpu.frames.size(); ++k) {
      for (const char* name : {"depth", "velocity_x", "velocity_y"}) {
        CHECK(field_of(on_cpu.frames[k], name) == field_of(on_device.frames[k], name));
      }
      CHECK(on_cpu.frames[k].statistics.kinetic_energy == on_device.frames[k].statistics.kinetic_energy);
    }
    CHECK(on_cpu.finals.max_speed == on_device.finals.max_speed);
  }
}

TEST_CASE("An interrupted run on the device goes on bit for bit on the CPU") {
  const Scene scene = collapse(200, 60, Precision::float32);
  MemorySink whole, first, second;
  run(scene, {}, whole);
  std::atomic<bool> interrupt = false;
  std::optional<Checkpoint> kept;
  RunOptions options;
  options.device = Device::cuda;
  options.interrupt = &interrupt;
  options.progress = [&](const Progress& progress) { interrupt = progress.steps >= 20; };
  options.checkpoint = [&](const Checkpoint& checkpoint) { kept = checkpoint; };
  run(scene, options, first);
  REQUIRE(kept);
  RunOptions rest;
  rest.resume = &*kept;
  run(scene, rest, second);
  CHECK(field_of(second.frames.back(), "depth") == field_of(whole.frames.back(), "depth"));
}

TEST_CASE("A grid that the device's memory does not hold is refused with the sizes") {
  BackendConfig config;
  config.grid.cells = {1 << 20, 1 << 20};
  config.grid.spacing = 0.01;
  InitialState initial;
  initial.friction_coefficient = {0.5}, initial.hbar_scale = {1.0}, initial.hbar_cap = {1e30};
  CHECK_THROWS_AS(make_cuda_backend(config, initial), DeviceError);
}

}  // namespace
}  // namespace sandsim::test
