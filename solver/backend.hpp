// The seam between the time loop and the machine that does the steps. One virtual call a step, none per cell.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "solver/initial_state.hpp"
#include "solver/objects/object.hpp"
#include "solver/particles.hpp"
#include "solver/report.hpp"
#include "solver/scene.hpp"
#include "solver/sink.hpp"
#include "solver/stepping.hpp"

namespace sandsim {

/// Sand to be added to the cells of a source.
struct SandRain {
  std::vector<std::int64_t> cells;  // j * nx + i
  double rate = 0.0;                // [m/s] growth of depth in each of them
  double start = 0.0, end = 0.0;    // [s]
};

/// What an object did to the sand in a step.
struct ObjectEffect {
  double overlapped_volume = 0.0;            // [m^3] of sand, before it was moved
  double displaced_volume = 0.0;             // [m^3]
  std::array<double, 2> momentum{0.0, 0.0};  // [m^4/s] given to the sand, per density
  double work = 0.0;                         // [m^5/s^2] likewise
  double deepest = 0.0;                      // [m] of the object under the highest sand beside it
  bool changed = false;                      // some sand, or what covers it
};

/// An object in a step: where it was and where it is, in the scene.
struct ObjectStep {
  std::size_t object = 0;  // of BackendConfig::objects
  objects::RigidState before, after;
  bool has_left = false;  // at the end of the step

  /// It does not move, neither before nor after.
  bool is_still() const;
};

/// What a backend has to know besides the initial state.
struct BackendConfig {
  Grid grid;
  double gravity = 9.8;  // [m/s^2]
  Boundaries boundaries;
  Numerics numerics;
  double courant = 0.6;
  std::vector<SandRain> rains;
  std::vector<std::shared_ptr<const objects::Object>> objects;
  std::optional<Particles> particles;
  bool maxima = false;   // keep max_depth, max_speed, arrival_time
  double above = 0.0;    // [m] thinner sand counts neither as arrived nor for the largest speed
  double drained = 0.0;  // [-] nor does the speed of what is left of a cell's largest depth, below this share of it
  int threads = 0;       // 0: as many as are free and pay, step by step; results do not depend on it
  int tile_columns = 0;  // 0: chosen by the backend; results do not depend on it
  int block_rows = 0;    // likewise
  bool covers = false;   // objects are bed for the flow where they cover sand: keep ground and buried sand apart
};

/// Sums over the grid (in an order that does not depend on threads).
struct GridStatistics {
  double volume = 0.0;          // [m^3]
  double kinetic_energy = 0.0;  // [m^5/s^2]
  double max_speed = 0.0;       // [m/s]
  std::int64_t moving_cells = 0;
  double max_depth = 0.0;        // [m]
  double max_speed_above = 0.0;  // [m/s] of sand deeper than config.above
};

/// A cell with the speed that bounds the step there.
struct SpeedLimit {
  int i = -1;
  int j = -1;
  double speed = 0.0;  // [m/s]
};

/// The stages of a run's report that a loop of steps adds to; null where the scene has no such stage.
struct LoopStages {
  StageReport *step = nullptr, *sources = nullptr, *maxima = nullptr, *objects = nullptr;
  std::vector<ObjectReport>* object_reports = nullptr;
};

/// What is taken from a state for a frame.
struct CaptureRequest {
  std::vector<std::string> fields;  // names as in series.h5
  std::vector<std::int64_t> cells;  // of the probes: j * nx + i
};
struct Capture {
  std::vector<FieldValues> fields;  // in the order of the request
  std::vector<ProbeSample> probes;
  ParticleFrame particles;  // empty unless config.particles
  GridStatistics statistics;
};

/// Holds the state and advances it.
class Backend {
 public:
  virtual ~Backend() = default;

  virtual std::string device() const = 0;
  virtual int threads() const = 0;
  virtual std::int64_t memory_bytes() const = 0;
  /// Bytes that one step moves between memory and the processor. [B/step]
  virtual double bytes_per_step() const = 0;

  virtual void set_state(const StateArrays& state) = 0;
  virtual StateArrays state() const = 0;

  /// Largest stable step of the present state; infinite if nothing can move. [s]
  virtual double stable_step() const = 0;
  /// The cell that bounds the step (a slow search, for messages).
  virtual SpeedLimit speed_limit() const = 0;
  /// Largest |ds|/(mu dx) - 1 over the faces between wet cells, 0 if none is above mu. (A slow search.) [-]
  virtual double slope_violation() const = 0;

  /// Takes the planned step of `loop` and those that follow by `rules`, sources and maxima included, until the loop
  /// halts or `most` steps are done. Calls `meanwhile` once: a device works on while it runs.
  virtual void advance(StepLoop& loop, const StepRules& rules, std::int64_t most, const LoopStages& stages,
                       const std::function<void()>& meanwhile) = 0;
  /// Moves the particles with the sand as it has flown since the last move, dt ago. [s] Only with config.particles; a
  /// capture takes them as they are.
  virtual void move_particles(double dt) = 0;
  virtual ParticleArrays particles() const = 0;
  virtual void set_particles(const ParticleArrays& particles) = 0;
  virtual ParticleReport particle_report() const = 0;

  /// Begins to take a copy of the present state; the next steps may follow at once.
  virtual void begin_capture(const CaptureRequest& request) = 0;
  /// The copy that was begun last, when it is complete.
  virtual Capture end_capture() = 0;

  /// One step of length dt [s] with the paper's or the balanced scheme, without sources and maxima.
  virtual StepOutcome step(double dt) = 0;
  /// Adds rate * dt to the depth of each cell of the rain; returns the volume that the cells gained. [m^3]
  virtual double rain(const SandRain& rain, double dt) = 0;
  /// Lets one object of a step act on the present state; `all` are the objects of that step, itself included.
  virtual ObjectEffect couple(const ObjectStep& one, const std::vector<ObjectStep>& all) = 0;

  virtual GridStatistics statistics() const = 0;
  /// One output field by its name in series.h5.
  virtual FieldValues field(const std::string& name) const = 0;
  /// Depth and velocity of single cells (j * nx + i).
  virtual std::vector<ProbeSample> sample(const std::vector<std::int64_t>& cells) const = 0;

  /// Takes the present state into the maxima; `time` in s. Only with config.maxima.
  virtual void update_maxima(double time) = 0;
  virtual FinalFields maxima() const = 0;
  virtual void set_maxima(const FinalFields& fields) = 0;

  /// First cell with a value that is not finite or a negative depth, in row order; i = -1 if there is none.
  virtual Incident find_broken() const = 0;
};

/// Backend::advance() for a backend that is told each step.
void advance_step_by_step(Backend& backend, const BackendConfig& config, StepLoop& loop, const StepRules& rules,
                          std::int64_t most, const LoopStages& stages);

/// The CPU backend. Throws DeviceError if the memory is not there.
std::unique_ptr<Backend> make_cpu_backend(const BackendConfig& config, const InitialState& initial);

}  // namespace sandsim
