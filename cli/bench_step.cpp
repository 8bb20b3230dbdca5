#include "cli/bench_step.hpp"

#include <chrono>
#include <stdexcept>
#include <utility>
#include <vector>

#include "solver/simulation.hpp"

namespace sandsim::cli {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// Steps of a backend as a run takes them, each as long as is stable, on the way to a frame that is far away.
class Steps {
 public:
  Steps(Backend& backend, const StateArrays& state) : backend_(backend), state_(state) { restart(); }

  void restart() {
    backend_.set_state(state_);
    loop_ = {};
    loop_.plan(rules_, backend_.stable_step());
    take(2);  // The first step finds the caches full of something else, and a device records its loop.
  }
  /// From the first state again where friction would stop some of the sand on the way.
  void restart_before(int count) {
    if (loop_.steps + count > steps_that_move) {
      restart();
    }
  }
  void take(int count) {
    const std::int64_t end = loop_.steps + count;
    while (loop_.steps < end) {
      if (loop_.halt != Halt::none && loop_.halt != Halt::smallest_step) {
        throw std::logic_error("the steps of the bench came to a halt");
      }
      loop_.halt = Halt::none;
      backend_.advance(loop_, rules_, end - loop_.steps, {&stage_, nullptr, nullptr}, [] {});
    }
  }
  /// [s]
  double time(int count) {
    const auto begin = Clock::now();
    take(count);
    return seconds_since(begin);
  }

 private:
  Backend& backend_;
  const StateArrays& state_;
  StepRules rules_{.due = 1e9};
  StepLoop loop_;
  StageReport stage_;
};

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
  scene.grid.spacing = 0.01;
  scene.sand.friction_angle = 0.54;
  scene.sand.hbar = {HbarPolicy::truncated, 0.0, 0.8, 0.05};
  Fill fill;
  fill.depth = 0.2;
  scene.sand.initial.push_back(
      SandBox{{0.0, 0.0}, {0.25 * columns * scene.grid.spacing, rows * scene.grid.spacing}, fill});
  scene.time.end = 1e-3;
  scene.time.frame_interval = 1e-3;
  return scene;
}

}  // namespace

StepSpeed measure_step(const MakeBackend& make, const StepCase& which, int size, const StateArrays& moving, int threads,
                       int repeats, int steps) {
  const std::unique_ptr<Backend> backend = make(bench_config(which, size, threads), bench_initial(which, size));
  Steps run(*backend, moving);
  const double cells = static_cast<double>(size) * size;
  std::vector<double> rates;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    run.restart_before(steps);
    rates.push_back(cells * steps / run.time(steps));
  }
  return {summarise(std::move(rates)), backend->bytes_per_step() / cells,
          static_cast<double>(backend->statistics().moving_cells) / cells};
}

FrameCost measure_frame(const MakeBackend& make, const StepCase& which, int size, int threads, int repeats) {
  constexpr int long_loop = 50;
  const std::unique_ptr<Backend> backend = make(bench_config(which, size, threads), bench_initial(which, size));
  const CaptureRequest request{{"depth", "velocity_x", "velocity_y"}, {}};
  const StateArrays moving = moving_state(which.precision, size);
  Steps run(*backend, moving);
  const auto take_frame = [&] {
    backend->begin_capture(request);
    run.take(1);
    backend->end_capture();
  };
  take_frame();  // which reserves its memory
  std::vector<double> steps, frames;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    run.restart_before(long_loop + 1);
    steps.push_back(run.time(long_loop) / long_loop);
    const auto begin = Clock::now();
    take_frame();
    frames.push_back(seconds_since(begin));
  }
  return {summarise(std::move(frames)), summarise(std::move(steps))};
}

Measurement measure_ensemble(const MakeEnsemble& make, const StepCase& which, int size, int runs, int repeats) {
  constexpr int steps = 100;
  const EnsembleMember member{bench_config(which, size, 1), bench_initial(which, size)};
  const std::unique_ptr<Ensemble> ensemble = make(std::vector<EnsembleMember>(static_cast<std::size_t>(runs), member));
  const StateArrays moving = moving_state(which.precision, size);
  const std::vector<StepRules> rules(ensemble->size(), StepRules{.due = 1e9});
  std::vector<StepLoop> loops(ensemble->size());
  std::vector<double> rates;
  for (int repeat = 0; repeat <= repeats; ++repeat) {
    for (std::size_t k = 0; k < ensemble->size(); ++k) {
      ensemble->member(k).set_state(moving);
      loops[k] = StepLoop{};
      loops[k].plan(rules[k], ensemble->member(k).stable_step());
    }
    const auto begin = Clock::now();
    double taken = 0.0;
    while (taken < static_cast<double>(steps) * runs) {
      for (StepLoop& loop : loops) {
        loop.halt = Halt::none;  // nobody asks for the cell of the smallest step
      }
      ensemble->advance(loops, rules, steps);
      taken = 0.0;
      for (const StepLoop& loop : loops) {
        taken += static_cast<double>(loop.steps);
      }
    }
    if (repeat > 0) {  // the first launch loads the kernel
      rates.push_back(taken / seconds_since(begin));
    }
  }
  return summarise(std::move(rates));
}

Measurement measure_start(Device device, int columns, int rows, int threads, int repeats) {
  const Scene scene = dam_break(columns, rows);
  RunOptions options;
  options.device = device;
  options.threads = threads;
  std::vector<double> seconds;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    NoSink sink;
    seconds.push_back(run(scene, options, sink).first_step_time);
  }
  return summarise(std::move(seconds));
}

}  // namespace sandsim::cli
