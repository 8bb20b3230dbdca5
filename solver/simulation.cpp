#include "solver/simulation.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "solver/backend.hpp"
#include "solver/backend_config.hpp"
#include "solver/initial_state.hpp"
#include "solver/reference/compare.hpp"
#include "solver/snapshot.hpp"
#include "solver/step_log.hpp"

namespace sandsim {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Relative drift of the volume above which a run is broken: two orders above what the schemes keep to.
double drift_tolerance(Precision precision) {
  return precision == Precision::float32 ? 1e-4 : 1e-11;
}

/// Adds the time of a scope to a stage.
class StageTimer {
 public:
  explicit StageTimer(StageReport& stage, double bytes) : stage_(stage) {
    stage_.launches += 1;
    stage_.bytes += bytes;
  }
  ~StageTimer() { stage_.seconds += seconds_since(start_); }
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;

 private:
  StageReport& stage_;
  Clock::time_point start_ = Clock::now();
};

/// One run, from its start or a checkpoint to its end.
class Run {
 public:
  Run(const Scene& scene, const RunOptions& options, Sink& sink);
  RunReport go();

 private:
  enum class Next { go_on, stop };

  void resume(const Checkpoint& checkpoint);
  Checkpoint checkpoint() const;
  Next advance_to(double due);
  double choose_step(double due, double bound, bool& limited);
  bool step_is_sound(double bound);
  void step(double dt, double bound, bool limited);
  void rain(double dt);
  bool rains_from(double time) const;
  void frame();
  Next look_up();
  void save_checkpoint();
  void fail(Incident incident, const std::string& problem, const std::string& suggestion = "");
  void finish();
  StageReport* stage(const std::string& name);
  double wall() const { return wall_before_ + seconds_since(start_); }

  const Scene& scene_;
  const RunOptions& options_;
  Sink& sink_;
  Clock::time_point start_ = Clock::now();
  InitialState initial_;
  FrameSchedule schedule_;
  std::unique_ptr<Backend> backend_;
  std::vector<SandRain> rains_;
  Snapshots snapshots_;
  RunReport report_;
  StageReport *steps_ = nullptr, *sources_ = nullptr, *maxima_ = nullptr, *frames_ = nullptr;  // in report_
  double time_ = 0.0;
  double target_ = 0.0;  // [s] where the steps land next
  double wall_before_ = 0.0;
  double last_checkpoint_ = 0.0;
  StepLog steps_log_;
  double rain_step_ = std::numeric_limits<double>::infinity();
  double last_motion_ = 0.0;
};

Run::Run(const Scene& scene, const RunOptions& options, Sink& sink)
    : scene_(scene),
      options_(options),
      sink_(sink),
      initial_(build_initial_state(scene)),
      schedule_(scene.time),
      backend_(make_backend(scene, initial_, options.threads)),
      rains_(sand_rains(scene)),
      snapshots_(scene, initial_) {
  const Numerics& numerics = scene.numerics;
  report_.device = backend_->device();
  report_.threads = backend_->threads();
  report_.precision = numerics.precision == Precision::float32 ? "float32" : "float64";
  report_.scheme = numerics.scheme == Scheme::balanced ? "balanced" : "paper";
  report_.order = numerics.scheme == Scheme::balanced ? numerics.order : 1;
  report_.cells = static_cast<std::int64_t>(scene.grid.cell_count());
  report_.memory_bytes = backend_->memory_bytes();
  for (const std::string& name : stage_names(scene)) {
    report_.stages.push_back({name, 0.0, 0, 0.0});
  }
  steps_ = stage("step"), sources_ = stage("sources"), maxima_ = stage("maxima"), frames_ = stage("frames");
  report_.ledger.initial = report_.ledger.final = backend_->statistics().volume;
  for (const SandRain& rain : rains_) {
    // A step may neither pile up more than a tenth of a spacing nor outlast a fall over one spacing: sand on a dry
    // bed has no wave speed yet that would bound the step.
    const double dx = scene.grid.spacing;
    rain_step_ = std::min(
        {rain_step_, 0.1 * dx / rain.rate, scene.gravity > 0.0 ? std::sqrt(dx / scene.gravity) : schedule_.interval});
  }
}

/// Null if the scene has no such stage.
StageReport* Run::stage(const std::string& name) {
  const auto found = std::find_if(report_.stages.begin(), report_.stages.end(),
                                  [&](const StageReport& stage) { return stage.name == name; });
  return found == report_.stages.end() ? nullptr : &*found;
}

void Run::resume(const Checkpoint& from) {
  backend_->set_state({from.depth, from.momentum_x, from.momentum_y});
  if (scene_.output.maxima) {
    backend_->set_maxima({from.max_depth, from.max_speed, from.arrival_time});
  }
  report_.steps = from.steps;
  report_.frames = from.frames;
  report_.ledger = from.ledger;
  steps_log_ = StepLog(from);
  time_ = from.time;
  last_motion_ = from.stop_time;
  wall_before_ = from.wall_time;
}

Checkpoint Run::checkpoint() const {
  Checkpoint to;
  to.steps = report_.steps;
  to.frames = report_.frames;
  to.time = time_;
  to.wall_time = wall();
  to.ledger = report_.ledger;
  steps_log_.save(to);
  to.stop_time = last_motion_;
  StateArrays state = backend_->state();
  to.depth = std::move(state.depth);
  to.momentum_x = std::move(state.momentum_x), to.momentum_y = std::move(state.momentum_y);
  if (scene_.output.maxima) {
    FinalFields maxima = backend_->maxima();
    to.max_depth = std::move(maxima.max_depth), to.max_speed = std::move(maxima.max_speed);
    to.arrival_time = std::move(maxima.arrival_time);
  }
  return to;
}

RunReport Run::go() {
  if (options_.resume != nullptr) {
    resume(*options_.resume);
  }
  StaticFields statics;
  if (!initial_.bed.empty()) {
    statics.bed = backend_->field("bed");
  }
  sink_.begin(scene_, statics);
  if (report_.frames == 0) {
    if (scene_.output.maxima) {
      backend_->update_maxima(0.0);
    }
    frame();
  }
  report_.first_step_time = seconds_since(start_);
  report_.status = "done";
  while (report_.frames < schedule_.count()) {
    const Next next = advance_to(schedule_.due(report_.frames));
    if (report_.failure || next == Next::stop) {
      break;
    }
    frame();
    if (report_.failure) {
      break;
    }
    if (report_.at_rest && scene_.time.stop_at_rest) {
      report_.status = "at rest";
      break;
    }
  }
  finish();
  return report_;
}

/// Steps until `due`, or until nothing moves any more: then the time jumps there, since no step would change a thing.
Run::Next Run::advance_to(double due) {
  while (time_ < due) {
    if (report_.at_rest) {
      if (!scene_.time.stop_at_rest) {
        time_ = due;
      }
      return Next::go_on;
    }
    const double bound = std::min(backend_->stable_step(), rains_from(time_) ? rain_step_ : HUGE_VAL);
    if (!step_is_sound(bound)) {
      return Next::stop;
    }
    bool limited = false;
    const double dt = choose_step(due, bound, limited);
    step(dt, bound, limited);
    if (report_.failure || look_up() == Next::stop) {
      return Next::stop;
    }
  }
  return Next::go_on;
}

/// The next step's length. `target_` is where the steps have to land next: on the frame, or at the end of the running
/// fixed step.
double Run::choose_step(double due, double bound, bool& limited) {
  target_ = due;
  const double whole = scene_.time.step;
  if (scene_.time.mode == TimeMode::fixed) {
    const double end = (std::floor(time_ / whole + 1e-6) + 1.0) * whole;
    target_ = end > due - 1e-6 * whole ? due : end;
  }
  const double remaining = target_ - time_;
  const bool fits = scene_.time.mode == TimeMode::fixed && std::fabs(remaining - whole) < 1e-6 * whole;
  const double dt = fits ? whole : remaining;  // the same bits in every fixed step
  limited = bound * (1.0 + 1e-6) < dt;
  if (!limited) {
    return dt;
  }
  // The last steps before the target are made even, so that none is tiny.
  return 2.0 * bound > dt ? 0.5 * dt : bound;
}

/// A fixed step must keep to the bound unless it may be divided; an adaptive one must not collapse.
bool Run::step_is_sound(double bound) {
  const bool fixed = scene_.time.mode == TimeMode::fixed;
  const double shortest = scene_.time.minimum_step.value_or(1e-9 * scene_.time.end);
  const bool too_long = fixed && !scene_.time.subcycle && scene_.time.step > bound * (1.0 + 1e-6);
  const bool collapsed = bound < shortest;
  if (!too_long && !collapsed) {
    return true;
  }
  const SpeedLimit limit = backend_->speed_limit();
  Incident incident;
  incident.i = limit.i, incident.j = limit.j, incident.time = time_, incident.step = bound;
  if (too_long) {
    incident.cause = "the fixed step breaks the stability bound";
    fail(incident,
         "time.step = " + std::to_string(scene_.time.step) + " s is longer than the stability bound of " +
             std::to_string(bound) + " s",
         "Shorten time.step, or set time.subcycle: true?");
  } else {
    incident.cause = "the time step collapsed";
    fail(incident, "the stable step of " + std::to_string(bound) + " s is below time.minimum_step");
  }
  return false;
}

void Run::step(double dt, double bound, bool limited) {
  steps_log_.note(dt, time_, limited, *backend_);  // before the step: the cell that limits it is still the one
  StepOutcome outcome;
  {
    StageTimer timer(*steps_, backend_->bytes_per_step());
    outcome = backend_->step(dt);
  }
  report_.ledger.out += outcome.volume_out;
  rain(dt);
  time_ = limited ? time_ + dt : target_;
  report_.steps += 1;
  if (scene_.output.maxima) {
    StageTimer timer(*maxima_, 1.5 * backend_->bytes_per_step());
    backend_->update_maxima(time_);
  }
  if (outcome.broken) {
    Incident incident = backend_->find_broken();
    incident.time = time_, incident.step = dt;
    fail(incident, "numerical failure: " + incident.cause);
    return;
  }
  if (outcome.moving || outcome.changed) {
    last_motion_ = time_;
  } else if (!rains_from(time_) && (scene_.time.mode == TimeMode::fixed || dt >= 0.49 * std::min(bound, 1e30))) {
    // The same step again gives the same state. A step cut short could hide a change below rounding: those don't count.
    report_.at_rest = true;
  }
}

void Run::rain(double dt) {
  for (std::size_t k = 0; k < rains_.size(); ++k) {
    const SandSource& source = scene_.sand.sources[k];
    const double open = std::min(time_ + dt, source.end) - std::max(time_, source.start);
    if (open > 0.0) {
      StageTimer timer(*sources_, 0.0);
      report_.ledger.in += backend_->rain(rains_[k], open);
    }
  }
}

/// Whether some source is open at or after `time`.
bool Run::rains_from(double time) const {
  return std::any_of(scene_.sand.sources.begin(), scene_.sand.sources.end(),
                     [&](const SandSource& source) { return source.end > time; });
}

void Run::frame() {
  StageTimer timer(*frames_, snapshots_.field_bytes());
  const GridStatistics sums = backend_->statistics();
  report_.ledger.final = sums.volume;
  if (std::fabs(report_.ledger.error()) > drift_tolerance(scene_.numerics.precision)) {
    Incident incident;
    incident.time = time_;
    incident.cause = "volume drift";
    fail(incident, "the volume has drifted by " + std::to_string(report_.ledger.error()) + " of what was brought in");
  }
  sink_.frame(snapshots_.take(*backend_, report_.frames,
                              {time_, sums.volume, sums.kinetic_energy, sums.max_speed, steps_log_.frame_min(),
                               steps_log_.frame_max(), report_.steps, wall(), sums.moving_cells}));
  report_.frames += 1;
  steps_log_.start_frame();
}

/// Between steps: progress, interrupts, limits, checkpoints.
Run::Next Run::look_up() {
  if (report_.at_rest) {
    return Next::go_on;  // nothing is left to interrupt
  }
  const double now = seconds_since(start_);
  if (options_.progress) {
    const double solving = steps_->seconds;
    options_.progress(
        {time_, scene_.time.end, steps_log_.max(), report_.steps,
         solving > 0.0 ? static_cast<double>(report_.cells) * static_cast<double>(steps_->launches) / solving : 0.0});
  }
  if (options_.interrupt != nullptr && options_.interrupt->load(std::memory_order_relaxed)) {
    report_.status = "interrupted";
    report_.exit_code = ExitCode::interrupted;
  } else if (options_.max_wall > 0.0 && now >= options_.max_wall) {
    report_.status = "wall-clock limit";
    report_.exit_code = ExitCode::wall_clock_limit;
  } else {
    if (now - last_checkpoint_ >= scene_.output.checkpoint_interval) {
      save_checkpoint();
    }
    return Next::go_on;
  }
  report_.message = report_.status + " at t = " + std::to_string(time_) + " s";
  save_checkpoint();
  return Next::stop;
}

void Run::save_checkpoint() {
  if (options_.checkpoint) {
    options_.checkpoint(checkpoint());
  }
  last_checkpoint_ = seconds_since(start_);
}

void Run::fail(Incident incident, const std::string& problem, const std::string& suggestion) {
  report_.status = "failed";
  report_.exit_code = ExitCode::numerical_failure;
  report_.message = problem + ", at t = " + std::to_string(incident.time) + " s";
  if (incident.i >= 0) {
    report_.message += " in cell (" + std::to_string(incident.i) + ", " + std::to_string(incident.j) +
                       ") at x = " + std::to_string(scene_.grid.x(incident.i)) +
                       " m, y = " + std::to_string(scene_.grid.y(incident.j)) + " m";
  }
  report_.message += suggestion.empty() ? "" : ". " + suggestion;
  report_.failure = std::move(incident);
}

void Run::finish() {
  report_.simulated_time = time_;
  steps_log_.report(report_);
  report_.ledger.final = backend_->statistics().volume;
  report_.stop_time = report_.at_rest ? last_motion_ : 0.0;
  report_.max_slope_violation = backend_->slope_violation();
  double solving = 0.0;
  for (const StageReport& each : report_.stages) {
    solving += each.name == "frames" ? 0.0 : each.seconds;
  }
  if (solving > 0.0) {
    report_.cell_steps_per_second =
        static_cast<double>(report_.cells) * static_cast<double>(steps_->launches) / solving;
  }
  if (!report_.failure) {
    if (scene_.reference) {
      report_.errors = compare(scene_, initial_, time_, as_double(backend_->field("depth")));
    }
    if (report_.exit_code == ExitCode::done) {
      sink_.end(scene_.output.maxima ? backend_->maxima() : FinalFields{});
    }
  }
  report_.wall_time = wall();
}

}  // namespace

RunReport run(const Scene& scene, const RunOptions& options, Sink& sink) {
  return Run(scene, options, sink).go();
}

}  // namespace sandsim
