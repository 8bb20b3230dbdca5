#include "cli/fit/evaluator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <limits>
#include <thread>
#include <tuple>

#include "io/output/mesh_cache.hpp"
#include "io/scene/scene_reader.hpp"
#include "solver/errors.hpp"
#include "solver/reference/compare.hpp"
#include "solver/reference/piecewise_linear.hpp"
#include "solver/simulation.hpp"
#include "solver/snapshot.hpp"

namespace sandsim::cli {

namespace {

/// Keeps the fronts of all frames and the depth of the last.
class CurveSink : public Sink {
 public:
  explicit CurveSink(const FitReference& reference) : reference_(reference) {}

  void begin(const Scene& scene, const StaticFields&) override { grid_ = scene.grid; }
  void frame(Frame frame) override {
    depth_ = as_double(frame.fields.at(0).values);
    if (reference_.kind == FitReference::Kind::front) {
      times_.push_back(frame.statistics.time);
      fronts_.push_back(front(grid_, depth_, reference_.front_depth));
    }
  }
  void end(const FinalFields&) override {}

  /// [m] What the reference has `value` for; NaN where the run has no front. Fronts are linear between frames and stay
  /// after the last, depths are linear between cell centres.
  std::vector<double> computed() const {
    std::vector<double> x;
    for (int i = 0; i < grid_.cells[0]; ++i) {
      x.push_back(grid_.x(i));
    }
    const bool is_front = reference_.kind == FitReference::Kind::front;
    const PiecewiseLinear curve = is_front ? PiecewiseLinear(times_, fronts_) : PiecewiseLinear(x, depth_);
    std::vector<double> values;
    for (const double place : reference_.place) {
      values.push_back(curve(place));
    }
    return values;
  }

 private:
  const FitReference& reference_;
  Grid grid_;
  std::vector<double> times_, fronts_, depth_;
};

/// Only as long and with as much output as the comparison needs.
void trim(Scene& scene, const FitReference& reference) {
  scene.time.end = reference.time;
  scene.reference.reset();
  scene.output = Output{};
  scene.output.fields = {OutputField::depth};
}

double root_mean_square(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    sum += (a[k] - b[k]) * (a[k] - b[k]);
  }
  return std::sqrt(sum / static_cast<double>(a.size()));
}

}  // namespace

bool Evaluation::failed() const {
  return std::isnan(misfit);
}

Evaluator::Evaluator(const Sweep& base, const std::vector<FitParameter>& parameters, const FitReference& reference,
                     std::filesystem::path mesh_folder, const std::atomic<bool>& interrupt)
    : base_(base),
      parameters_(parameters),
      reference_(reference),
      mesh_folder_(std::move(mesh_folder)),
      interrupt_(interrupt) {}

void Evaluator::run(Evaluation& evaluation) const {
  evaluation.misfit = std::numeric_limits<double>::quiet_NaN();
  SweepCase one;
  one.values = values_at(parameters_, evaluation.point);
  CurveSink sink(reference_);
  RunReport report;
  try {
    Scene scene = read_scene(base_.scene, base_.overrides_of(one));
    trim(scene, reference_);
    bake_meshes(scene, mesh_folder_);
    RunOptions options;
    options.threads = 1;
    options.interrupt = &interrupt_;
    report = sandsim::run(scene, options, sink);
  } catch (const SceneError& error) {
    evaluation.status = "invalid";
    evaluation.message = error.what();
    return;
  }
  if (report.exit_code == ExitCode::interrupted) {
    throw FitInterrupted{};
  }
  evaluation.status = report.status;
  if (report.exit_code != ExitCode::done) {
    evaluation.message = report.message;
    return;
  }
  evaluation.misfit = root_mean_square(sink.computed(), reference_.value);
  if (evaluation.failed()) {
    evaluation.message = fmt::format("no sand is deeper than {:g} m: there is no front", reference_.front_depth);
  }
}

Evaluation Evaluator::evaluate(const FitPoint& point, const Origin& origin) {
  if (interrupt_.load(std::memory_order_relaxed)) {
    throw FitInterrupted{};
  }
  const auto begin = std::chrono::steady_clock::now();
  Evaluation evaluation;
  evaluation.origin = origin;
  evaluation.point = point;
  run(evaluation);
  evaluation.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const std::lock_guard lock(mutex_);
  log_.push_back(evaluation);
  if (observer_) {
    observer_(evaluation);
  }
  return evaluation;
}

std::vector<Evaluation> Evaluator::log() const {
  const std::lock_guard lock(mutex_);
  std::vector<Evaluation> sorted = log_;
  std::sort(sorted.begin(), sorted.end(), [](const Evaluation& a, const Evaluation& b) {
    const auto key = [](const Origin& origin) { return std::tuple(origin.stage, origin.task, origin.step); };
    return key(a.origin) < key(b.origin);
  });
  return sorted;
}

void for_each_task(std::size_t count, int parallel, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::exception_ptr first;
  const auto take = [&] {
    for (std::size_t k = next++; k < count; k = next++) {
      try {
        work(k);
      } catch (...) {
        const std::lock_guard lock(mutex);
        first = first ? first : std::current_exception();
        next = count;
      }
    }
  };
  std::vector<std::jthread> threads;
  for (std::size_t k = 1; k < std::min(count, static_cast<std::size_t>(parallel)); ++k) {
    threads.emplace_back(take);
  }
  take();
  threads.clear();
  if (first) {
    std::rethrow_exception(first);
  }
}

}  // namespace sandsim::cli
