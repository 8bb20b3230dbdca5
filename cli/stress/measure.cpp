#include "cli/stress/measure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>
#include <variant>

#include "cli/failures.hpp"
#include "io/output/mesh_cache.hpp"
#include "io/scene/scene_reader.hpp"
#include "solver/backend_config.hpp"
#include "solver/simulation.hpp"

namespace sandsim::cli {

namespace {

/// Looks at every frame, and keeps the first and the last one; the speed is that of all steps if the run ends well.
class Watch : public Sink {
 public:
  void begin(const Scene&, const StaticFields&) override {}
  void frame(Frame frame) override {
    fastest_ = std::max(fastest_, frame.statistics.max_speed);
    for (const NamedField& field : frame.fields) {
      std::visit([&](const auto& values) { look(values, field.name == "depth"); }, field.values);
    }
    if (!has_first_) {
      first_ = frame.fields;
      has_first_ = true;
    }
    last_ = std::move(frame.fields);
  }
  void end(const FinalFields& fields) override {
    std::visit(
        [&](const auto& speeds) {
          for (const auto speed : speeds) {
            fastest_ = std::max(fastest_, static_cast<double>(speed));
          }
        },
        fields.max_speed);
  }

  bool is_finite() const { return is_finite_; }
  bool is_positive() const { return is_positive_; }
  double fastest() const { return fastest_; }
  /// Whether the last frame has the values of the first (a zero has no sign).
  bool is_unchanged() const;
  /// Whether the last frames of two runs have the same bits.
  bool ends_like(const Watch& other) const;

 private:
  template <class Real>
  void look(const std::vector<Real>& values, bool is_depth) {
    is_finite_ = is_finite_ && std::all_of(values.begin(), values.end(), [](Real v) { return std::isfinite(v); });
    is_positive_ =
        is_positive_ && !(is_depth && std::any_of(values.begin(), values.end(), [](Real v) { return v < Real(0); }));
  }

  std::vector<NamedField> first_, last_;
  bool has_first_ = false, is_finite_ = true, is_positive_ = true;
  double fastest_ = 0.0;
};

bool Watch::is_unchanged() const {
  return std::equal(first_.begin(), first_.end(), last_.begin(), last_.end(),
                    [](const NamedField& a, const NamedField& b) { return a.values == b.values; });
}

template <class Real>
bool same_bits(const std::vector<Real>& a, const FieldValues& other) {
  const auto& b = std::get<std::vector<Real>>(other);
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Real)) == 0;
}

bool Watch::ends_like(const Watch& other) const {
  return std::equal(last_.begin(), last_.end(), other.last_.begin(), other.last_.end(),
                    [](const NamedField& a, const NamedField& b) {
                      return std::visit([&](const auto& values) { return same_bits(values, b.values); }, a.values);
                    });
}

/// E of a scene, see Criteria. [m/s]
double energy_speed(const Scene& scene, const InitialState& initial, const Criteria& criteria) {
  double fastest = 0.0, top = -HUGE_VAL, bottom = HUGE_VAL;
  for (std::size_t cell = 0; cell < initial.depth.size(); ++cell) {
    const double h = initial.depth[cell], b = initial.bed.empty() ? 0.0 : initial.bed[cell];
    bottom = std::min(bottom, b);
    if (h <= 0.0) {
      continue;
    }
    top = std::max(top, b + h);
    if (!initial.momentum_x.empty()) {
      fastest = std::max(fastest, std::hypot(initial.momentum_x[cell], initial.momentum_y[cell]) / h);
    }
  }
  const double height = std::max(0.0, top - bottom) + criteria.rise;
  return fastest + criteria.push + std::sqrt(scene.gravity * height);
}

/// The length of steps and frames in stability bounds of the initial state: about as long as the scene's own run.
void fix_steps(Scene& scene, double bounds) {
  const auto backend = make_backend(backend_config(scene, 1), build_initial_state(scene), Device::cpu);
  TimeControl& time = scene.time;
  time.mode = TimeMode::fixed;
  time.step = bounds * backend->stable_step();
  const double steps = std::max(1.0, std::round(time.frame_interval / time.step));
  const double frames = std::round(time.end / time.frame_interval);
  time.frame_interval = steps * time.step;
  time.end = frames * time.frame_interval;
}

RunReport run_watched(const Scene& scene, const MeasureOptions& options, Watch& watch) {
  RunOptions run_options;
  run_options.device = options.device;
  run_options.threads = 1;  // the trials run side by side
  run_options.max_wall = options.max_wall;
  return run(scene, run_options, watch);
}

Measurement measure_scene(Scene scene, const Trial& trial, const MeasureOptions& options) {
  scene.output.fields = {OutputField::depth, OutputField::momentum};
  scene.output.frames = true;
  scene.output.maxima = MaximaOutput{0.0};  // sand of any depth has to keep to the bound
  scene.reference.reset();
  Measurement measured;
  measured.spacing = scene.grid.spacing;
  measured.energy_speed = energy_speed(scene, build_initial_state(scene), trial.criteria);
  Watch watch, again;
  const RunReport report = run_watched(scene, options, watch);
  const RunReport repeated = run_watched(scene, options, again);
  measured.exit_code = static_cast<int>(report.exit_code);
  measured.message = report.message;
  measured.is_finite = watch.is_finite();
  measured.is_positive = watch.is_positive();
  // What a clock has stopped need not be repeated; a run that breaks at a frame may have gone some steps beyond it.
  measured.is_repeated =
      report.exit_code == ExitCode::wall_clock_limit || (watch.ends_like(again) && report.message == repeated.message &&
                                                         (report.steps == repeated.steps || report.failure));
  measured.is_unchanged = watch.is_unchanged();
  measured.at_rest = report.at_rest;
  measured.slope_violation = report.max_slope_violation;
  measured.steps = report.steps;
  measured.volume_error = report.ledger.error();
  measured.max_speed = watch.fastest();
  measured.dt_min = report.dt_min;
  measured.wall_time = report.wall_time;
  return measured;
}

}  // namespace

std::string Variant::name() const {
  return order > 0 ? fmt::format("{} order {}", scheme, order) : scheme;
}

std::string Variant::file_name() const {
  return fmt::format("{}{}_{}", scheme, order > 0 ? std::to_string(order) : "", precision_name());
}

std::vector<std::string> Variant::overrides() const {
  const std::string order_key = order > 0 ? fmt::format(", order: {}", order) : "";
  return {fmt::format("numerics={{scheme: {}{}, precision: {}}}", scheme, order_key, precision_name())};
}

std::vector<Variant> all_variants() {
  std::vector<Variant> variants;
  for (const auto& [scheme, order] : {std::pair("paper", 0), std::pair("balanced", 1), std::pair("balanced", 2)}) {
    for (const Precision precision : {Precision::float32, Precision::float64}) {
      variants.push_back({scheme, order, precision});
    }
  }
  return variants;
}

Scene trial_scene(const Trial& trial) {
  Scene scene = read_scene(trial.scene, trial.variant.overrides());
  bake_meshes(scene, std::filesystem::temp_directory_path());
  if (trial.step_in_bounds > 0.0) {
    fix_steps(scene, trial.step_in_bounds);
  }
  return scene;
}

Measurement measure(const Trial& trial, const MeasureOptions& options) {
  try {
    return measure_scene(trial_scene(trial), trial, options);
  } catch (...) {
    const Failure failure = current_failure();
    Measurement measured;
    measured.exit_code = failure.exit_code;
    measured.message = failure.message;
    return measured;
  }
}

}  // namespace sandsim::cli
