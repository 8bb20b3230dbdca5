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
#include "solver/object_stage.hpp"
#include "solver/reference/compare.hpp"
#include "solver/snapshot.hpp"
#include "solver/stage_timer.hpp"
#include "solver/step_rules.hpp"

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

/// Between two looks at interrupts and limits the steps should take about this long. [s]
constexpr double look_interval = 0.01;

double largest(const FieldValues& values) {
  return std::visit([](const auto& v) { return static_cast<double>(*std::max_element(v.begin(), v.end())); }, values);
}

BackendConfig config_of(const Scene& scene, const InitialState& initial, int threads) {
  BackendConfig config = backend_config(scene, threads);
  config.above = thin_depth(scene, initial);
  config.drained = scene.output.maxima && !scene.output.maxima->above ? drained_share : 0.0;
  return config;
}

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
  void steps();
  void locate_smallest_step();
  void report_halt();
  void move_particles();
  void begin_frame();
  void deliver_frame();
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
  BackendConfig backend_config_;
  std::unique_ptr<Backend> backend_;
  Snapshots snapshots_;
  RunoutMeter runout_;
  RunReport report_;
  LoopStages stages_;                 // in report_
  StageReport* frames_ = nullptr;     // likewise
  StageReport* particles_ = nullptr;  // likewise; null without particles
  StepRules rules_;
  StepLoop loop_;
  std::optional<FrameStatistics> pending_;  // of the frame that is being captured
  std::int64_t steps_a_look_ = 1;
  double wall_before_ = 0.0;
  double last_checkpoint_ = 0.0;
};

Run::Run(const Scene& scene, const RunOptions& options, Sink& sink)
    : scene_(scene),
      options_(options),
      sink_(sink),
      initial_(build_initial_state(scene)),
      schedule_(scene.time),
      backend_config_(config_of(scene, initial_, options.threads)),
      backend_(make_backend(backend_config_, initial_, options.device)),
      snapshots_(scene, initial_, backend_config_.objects),
      runout_(scene, initial_),
      rules_(step_rules(scene, backend_config_, backend_->stable_step())) {
  const Numerics& numerics = scene.numerics;
  report_.device = backend_->device();
  report_.threads = backend_->threads();
  report_.precision = numerics.precision == Precision::float32 ? "float32" : "float64";
  report_.scheme = numerics.scheme == Scheme::balanced ? "balanced" : "paper";
  report_.order = numerics.scheme == Scheme::balanced ? numerics.order : 1;
  report_.cells = static_cast<std::int64_t>(scene.grid.cell_count());
  for (const std::string& name : stage_names(scene)) {
    report_.stages.push_back({name, 0.0, 0, 0.0});
  }
  for (const auto& object : backend_config_.objects) {
    report_.objects.push_back({});
    report_.objects.back().name = object->name();
  }
  stages_ = {stage("step"), stage("sources"), stage("maxima"), stage("objects"), &report_.objects};
  frames_ = stage("frames"), particles_ = stage("particles");
  report_.release = initial_.release;
  if (options.warn) {
    std::for_each(initial_.warnings.begin(), initial_.warnings.end(), options.warn);
  }
  report_.ledger.initial = report_.ledger.final = backend_->statistics().volume;
}

/// Null if the scene has no such stage.
StageReport* Run::stage(const std::string& name) {
  const auto found = std::find_if(report_.stages.begin(), report_.stages.end(),
                                  [&](const StageReport& stage) { return stage.name == name; });
  return found == report_.stages.end() ? nullptr : &*found;
}

void Run::resume(const Checkpoint& from) {
  backend_->set_state(from.state);
  if (scene_.output.maxima) {
    backend_->set_maxima({from.max_depth, from.max_speed, from.arrival_time});
  }
  runout_.set_record(from.runout);
  if (scene_.particles) {
    backend_->set_particles(from.particles);
  }
  report_.frames = from.frames;
  report_.ledger = from.ledger;
  loop_.steps = from.steps;
  loop_.time = from.time;
  loop_.last_motion = from.stop_time;
  loop_.volume_in = from.ledger.in, loop_.volume_out = from.ledger.out;
  StepExtremes& extremes = loop_.extremes;
  extremes.min = from.dt_min, extremes.max = from.dt_max;
  extremes.frame_min = from.frame_step_min, extremes.frame_max = from.frame_step_max;
  extremes.any_limited = from.smallest_step.i >= 0;
  extremes.smallest_i = from.smallest_step.i, extremes.smallest_j = from.smallest_step.j;
  extremes.smallest_time = from.smallest_step.time, extremes.smallest_step = from.smallest_step.step;
  wall_before_ = from.wall_time;
}

/// The smallest step and its cell, if any was taken.
std::optional<Incident> smallest_step(const StepExtremes& extremes) {
  if (extremes.smallest_step == 0.0) {
    return std::nullopt;
  }
  Incident incident;
  incident.i = extremes.smallest_i, incident.j = extremes.smallest_j;
  incident.time = extremes.smallest_time, incident.step = extremes.smallest_step;
  incident.cause = extremes.any_limited ? "stability bound" : "cut to land on a frame";
  return incident;
}

Checkpoint Run::checkpoint() const {
  Checkpoint to;
  to.steps = loop_.steps;
  to.frames = report_.frames;
  to.time = loop_.time;
  to.wall_time = wall();
  to.ledger = report_.ledger;
  to.ledger.in = loop_.volume_in, to.ledger.out = loop_.volume_out;
  to.dt_min = loop_.extremes.min, to.dt_max = loop_.extremes.max;
  to.frame_step_min = loop_.extremes.frame_min, to.frame_step_max = loop_.extremes.frame_max;
  to.smallest_step = smallest_step(loop_.extremes).value_or(Incident{});
  to.stop_time = loop_.last_motion;
  to.state = backend_->state();
  if (scene_.particles) {
    to.particles = backend_->particles();
  }
  if (scene_.output.maxima) {
    FinalFields maxima = backend_->maxima();
    to.max_depth = std::move(maxima.max_depth), to.max_speed = std::move(maxima.max_speed);
    to.arrival_time = std::move(maxima.arrival_time);
  }
  to.runout = runout_.record();
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
    begin_frame();
  }
  report_.first_step_time = seconds_since(start_);
  report_.status = "done";
  while (report_.frames < schedule_.count()) {
    const Next next = advance_to(schedule_.due(report_.frames));
    if (report_.failure || next == Next::stop) {
      break;
    }
    begin_frame();
    if (report_.failure) {
      break;
    }
    if (loop_.at_rest && scene_.time.stop_at_rest) {
      report_.status = "at rest";
      break;
    }
  }
  finish();
  return report_;
}

/// Steps until `due`, or until nothing moves any more: then the time jumps there, since no step would change a thing.
Run::Next Run::advance_to(double due) {
  rules_.due = due;
  loop_.halt = Halt::none;
  loop_.plan(rules_,
             std::min(backend_->stable_step(), object_step(backend_config_.objects, loop_.time, backend_config_)));
  locate_smallest_step();
  while (true) {
    if (loop_.halt == Halt::due) {
      return Next::go_on;
    }
    if (loop_.halt == Halt::at_rest) {
      if (!scene_.time.stop_at_rest) {
        loop_.time = due;
      }
      return Next::go_on;
    }
    if (loop_.halt == Halt::none) {
      steps();
    }
    locate_smallest_step();
    report_halt();
    if (report_.failure || look_up() == Next::stop) {
      return Next::stop;
    }
  }
}

/// As many steps as fit between two looks at interrupts and limits.
void Run::steps() {
  const std::int64_t before = loop_.steps;
  const Clock::time_point start = Clock::now();
  backend_->advance(loop_, rules_, steps_a_look_, stages_, [this] { deliver_frame(); });
  const double seconds = seconds_since(start);
  if (seconds > 2.0 * look_interval) {
    steps_a_look_ = std::max<std::int64_t>(1, steps_a_look_ / 2);
  } else if (seconds < 0.5 * look_interval && loop_.steps - before == steps_a_look_) {
    steps_a_look_ *= 2;
  }
}

/// Where the planned step is the smallest so far: which cell bounds it?
void Run::locate_smallest_step() {
  if (loop_.halt != Halt::smallest_step) {
    return;
  }
  const SpeedLimit limit = backend_->speed_limit();
  loop_.extremes.smallest_i = limit.i, loop_.extremes.smallest_j = limit.j;
  loop_.halt = Halt::none;
}

/// A halt that is a failure.
void Run::report_halt() {
  Incident incident;
  incident.time = loop_.time, incident.step = loop_.bound;
  if (loop_.halt == Halt::broken) {
    incident = backend_->find_broken();
    incident.time = loop_.time, incident.step = loop_.step;
    fail(incident, "numerical failure: " + incident.cause);
  } else if (loop_.halt == Halt::step_too_long || loop_.halt == Halt::step_collapsed) {
    const SpeedLimit limit = backend_->speed_limit();
    incident.i = limit.i, incident.j = limit.j;
    if (loop_.halt == Halt::step_too_long) {
      incident.cause = "the fixed step breaks the stability bound";
      fail(incident,
           "time.step = " + std::to_string(scene_.time.step) + " s is longer than the stability bound of " +
               std::to_string(loop_.bound) + " s",
           "Shorten time.step, or set time.subcycle: true?");
    } else {
      incident.cause = "the time step collapsed";
      fail(incident, "the stable step of " + std::to_string(loop_.bound) + " s is below time.minimum_step");
    }
  }
}

/// The particles go where the sand has carried them since the last frame. Moving them once a frame rather than with
/// every step is a matter of speed: there may be many particles to a cell, and many steps to a frame.
void Run::move_particles() {
  if (particles_ != nullptr) {
    StageTimer timer(*particles_, 0.0);
    const std::int64_t frame = report_.frames;
    backend_->move_particles(frame > 0 ? schedule_.due(frame) - schedule_.due(frame - 1) : 0.0);
  }
}

void Run::begin_frame() {
  deliver_frame();
  move_particles();
  StageTimer timer(*frames_, snapshots_.field_bytes());
  backend_->begin_capture(snapshots_.request());
  StepExtremes& extremes = loop_.extremes;
  pending_ = FrameStatistics{};
  pending_->time = loop_.time, pending_->steps = loop_.steps, pending_->wall_time = wall();
  pending_->time_step_min = extremes.frame_min, pending_->time_step_max = extremes.frame_max;
  extremes.frame_min = extremes.frame_max = 0.0;
  report_.ledger.in = loop_.volume_in, report_.ledger.out = loop_.volume_out;
  report_.frames += 1;
}

/// Hands the captured frame out, if there is one.
void Run::deliver_frame() {
  if (!pending_) {
    return;
  }
  StageTimer timer(*frames_, 0.0, 0);  // begin_frame() counted it
  Capture capture = backend_->end_capture();
  FrameStatistics numbers = *pending_;
  pending_.reset();
  const GridStatistics& sums = capture.statistics;
  numbers.volume = sums.volume, numbers.kinetic_energy = sums.kinetic_energy;
  numbers.max_speed = sums.max_speed, numbers.moving_cells = sums.moving_cells;
  report_.ledger.final = sums.volume;
  if (std::fabs(report_.ledger.error()) > drift_tolerance(scene_.numerics.precision)) {
    Incident incident;
    incident.time = numbers.time;
    incident.cause = "volume drift";
    fail(incident, "the volume has drifted by " + std::to_string(report_.ledger.error()) + " of what was brought in");
  }
  if (!scene_.output.maxima) {
    runout_.take(*snapshots_.depth(capture), sums.max_depth, sums.max_speed_above);
  }
  sink_.frame(snapshots_.frame(std::move(capture), report_.frames - 1, numbers));
}

/// Between steps: progress, interrupts, limits, checkpoints.
Run::Next Run::look_up() {
  if (loop_.at_rest) {
    return Next::go_on;  // nothing is left to interrupt
  }
  const double now = seconds_since(start_);
  if (options_.progress) {
    const double solving = stages_.step->seconds;
    options_.progress({loop_.time, scene_.time.end, loop_.extremes.max, loop_.steps,
                       solving > 0.0
                           ? static_cast<double>(report_.cells) * static_cast<double>(stages_.step->launches) / solving
                           : 0.0});
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
  report_.message = report_.status + " at t = " + std::to_string(loop_.time) + " s";
  save_checkpoint();
  return Next::stop;
}

void Run::save_checkpoint() {
  deliver_frame();  // a checkpoint counts it
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
  deliver_frame();
  report_.steps = loop_.steps;
  report_.threads = backend_->threads();
  report_.memory_bytes = backend_->memory_bytes();
  report_.at_rest = loop_.at_rest;
  report_.simulated_time = loop_.time;
  report_.ledger.in = loop_.volume_in, report_.ledger.out = loop_.volume_out;
  report_.dt_min = loop_.extremes.min, report_.dt_max = loop_.extremes.max;
  report_.smallest_step = smallest_step(loop_.extremes);
  report_.ledger.final = backend_->statistics().volume;
  report_.stop_time = report_.at_rest ? loop_.last_motion : 0.0;
  if (particles_ != nullptr) {
    report_.particles = backend_->particle_report();
  }
  report_.max_slope_violation = backend_->slope_violation();
  double solving = 0.0;
  for (const StageReport& each : report_.stages) {
    solving += each.name == "frames" || each.name == "particles" ? 0.0 : each.seconds;
  }
  if (solving > 0.0) {
    report_.cell_steps_per_second =
        static_cast<double>(report_.cells) * static_cast<double>(stages_.step->launches) / solving;
  }
  if (!report_.failure) {
    if (scene_.reference) {
      report_.errors = compare(scene_, initial_, loop_.time, as_double(backend_->field("depth")));
    }
    FinalFields maxima;
    if (scene_.output.maxima) {
      maxima = backend_->maxima();
      runout_.take(maxima.max_depth, largest(maxima.max_depth), largest(maxima.max_speed));
    }
    report_.runout = runout_.report(backend_->field("depth"), report_.ledger);
    if (report_.exit_code == ExitCode::done) {
      sink_.end(maxima);
    }
  }
  report_.wall_time = wall();
}

}  // namespace

RunReport run(const Scene& scene, const RunOptions& options, Sink& sink) {
  return Run(scene, options, sink).go();
}

}  // namespace sandsim
