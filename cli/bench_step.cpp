#include "cli/bench_step.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "solver/backend.hpp"
#include "solver/numerics.hpp"
#include "solver/simulation.hpp"

namespace sandsim::cli {

namespace {

constexpr double spacing = 0.01;  // [m] as in the paper's flume

/// sin(2 pi waves k/size) for every k: whole waves fit a periodic grid.
std::vector<double> wave(int size, int waves) {
  std::vector<double> values(static_cast<std::size_t>(size));
  for (std::size_t k = 0; k < values.size(); ++k) {
    values[k] = std::sin(2.0 * std::numbers::pi * waves * static_cast<double>(k) / size);
  }
  return values;
}

/// Waves of several lengths in both directions, between -1 and 1.
class Waves {
 public:
  explicit Waves(int size) : long_(wave(size, 3)), middle_(wave(size, 17)), short_(wave(size, size / 16)) {}

  double at(std::size_t i, std::size_t j) const {
    return 0.5 * long_[i] * long_[j] + 0.3 * middle_[i] * middle_[j] + 0.2 * short_[i] * short_[j];
  }

 private:
  std::vector<double> long_, middle_, short_;
};

/// Sand 14 to 26 cm deep that moves at 3 m/s along x and 1 m/s along y, give or take half a metre per second: friction
/// needs hundreds of steps to stop any of it.
template <class Real>
StateArrays moving_state(int size) {
  const auto side = static_cast<std::size_t>(size);
  const Waves waves(size);
  std::vector<Real> depth(side * side), momentum_x(side * side), momentum_y(side * side);
  for (std::size_t j = 0; j < side; ++j) {
    for (std::size_t i = 0; i < side; ++i) {
      const double ripple = waves.at(i, j);
      const double turned = waves.at(side - 1 - j, i);
      const double h = 0.2 + 0.06 * ripple;
      depth[j * side + i] = static_cast<Real>(h);
      momentum_x[j * side + i] = static_cast<Real>(h * (3.0 + 0.5 * turned));
      momentum_y[j * side + i] = static_cast<Real>(h * (1.0 - 0.5 * turned));
    }
  }
  return {std::move(depth), std::move(momentum_x), std::move(momentum_y)};
}

InitialState initial_state(const StepCase& which, int size) {
  const auto side = static_cast<std::size_t>(size);
  InitialState initial;
  initial.depth.assign(side * side, 0.2);
  initial.friction_coefficient = {0.5985};  // Section 7.1 of the paper, as is hbar = min(0.8 h, 5 cm).
  initial.hbar_scale = {0.8};
  initial.hbar_cap = {0.05};
  if (which.terrain) {
    const Waves waves(size);
    initial.bed.resize(side * side);
    for (std::size_t j = 0; j < side; ++j) {
      for (std::size_t i = 0; i < side; ++i) {
        initial.bed[j * side + i] = 0.05 * waves.at(j, i);
      }
    }
  }
  return initial;
}

BackendConfig backend_config(const StepCase& which, int size, int threads) {
  BackendConfig config;
  config.grid.cells = {size, size};
  config.grid.spacing = spacing;
  config.boundaries = {BoundaryKind::periodic, BoundaryKind::periodic, BoundaryKind::periodic, BoundaryKind::periodic};
  config.numerics.scheme = which.scheme;
  config.numerics.order = which.order;
  config.numerics.precision = which.precision;
  config.courant = default_courant(config.numerics);
  config.threads = threads;
  return config;
}

/// [s] for some steps, each as long as is stable, as in a run.
double time_steps(Backend& backend, int steps) {
  const auto begin = std::chrono::steady_clock::now();
  for (int step = 0; step < steps; ++step) {
    backend.step(backend.stable_step());
  }
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// A sink that takes everything and does nothing.
class NoSink : public Sink {
 public:
  void begin(const Scene&, const StaticFields&) override {}
  void frame(Frame) override {}
  void end(const FinalFields&) override {}
};

Scene dam_break(int columns, int rows) {
  Scene scene;
  scene.grid.cells = {columns, rows};
  scene.grid.spacing = spacing;
  scene.sand.friction_angle = 0.54;
  scene.sand.hbar = {HbarPolicy::truncated, 0.0, 0.8, 0.05};
  Fill fill;
  fill.depth = 0.2;
  scene.sand.initial.push_back(SandBox{{0.0, 0.0}, {0.25 * columns * spacing, rows * spacing}, fill});
  scene.time.end = 1e-3;
  scene.time.frame_interval = 1e-3;
  return scene;
}

}  // namespace

std::vector<StepCase> step_cases(const std::vector<Precision>& precisions) {
  std::vector<StepCase> cases;
  for (const Precision precision : precisions) {
    for (const bool terrain : {false, true}) {
      cases.push_back({Scheme::paper, 1, precision, terrain});
      cases.push_back({Scheme::balanced, 1, precision, terrain});
      cases.push_back({Scheme::balanced, 2, precision, terrain});
    }
  }
  return cases;
}

std::string scheme_name(const StepCase& which) {
  return which.scheme == Scheme::paper ? "paper" : fmt::format("balanced order {}", which.order);
}

double floor_bytes(const StepCase& which) {
  const double word = which.precision == Precision::float32 ? 4.0 : 8.0;
  return word * (which.terrain ? 8.0 : 7.0);
}

StepSpeed measure_step(const StepCase& which, int size, int threads, int repeats, int steps) {
  const std::unique_ptr<Backend> backend =
      make_cpu_backend(backend_config(which, size, threads), initial_state(which, size));
  const StateArrays state =
      which.precision == Precision::float32 ? moving_state<float>(size) : moving_state<double>(size);
  const double cells = static_cast<double>(size) * size;
  std::vector<double> rates;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    backend->set_state(state);
    time_steps(*backend, 1);  // The first step after set_state() finds the caches full of something else.
    rates.push_back(cells * steps / time_steps(*backend, steps));
  }
  return {summarise(std::move(rates)), backend->bytes_per_step() / cells,
          static_cast<double>(backend->statistics().moving_cells) / cells};
}

Measurement measure_start(int columns, int rows, int threads, int repeats) {
  const Scene scene = dam_break(columns, rows);
  RunOptions options;
  options.threads = threads;
  std::vector<double> seconds;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    NoSink sink;
    seconds.push_back(run(scene, options, sink).first_step_time);
  }
  return summarise(std::move(seconds));
}

}  // namespace sandsim::cli
