// What the solver hands out at every frame, and the seam through which it leaves the solver.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "solver/report.hpp"
#include "solver/scene.hpp"

namespace sandsim {

/// ny * nx values, x fastest, in the run's precision.
using FieldValues = std::variant<std::vector<float>, std::vector<double>>;

/// What a run goes on from: the sand that flows, and where objects cover sand, the bed as the flow sees it and what is
/// buried. ny * nx, x fastest, in the run's precision.
struct StateArrays {
  FieldValues depth, momentum_x, momentum_y;  // [m], [m^2/s]
  FieldValues bed{};                          // [m] empty without covering objects
  FieldValues buried{};                       // [m] likewise; always float64

  bool has_covers() const {
    return std::visit([](const auto& values) { return !values.empty(); }, bed);
  }
};

/// The numbers of one frame (names as in series.h5).
struct FrameStatistics {
  double time = 0.0;              // [s]
  double volume = 0.0;            // [m^3]
  double kinetic_energy = 0.0;    // [m^5/s^2] sum of (hu^2 + hv^2)/(2 h) dx^2: per density
  double max_speed = 0.0;         // [m/s]
  double time_step_min = 0.0;     // [s] over the steps since the last frame
  double time_step_max = 0.0;     // [s]
  std::int64_t steps = 0;         // since the start of the run
  double wall_time = 0.0;         // [s] since the start of the run
  std::int64_t moving_cells = 0;  // cells with momentum
};

/// One named field of a frame: "depth", "velocity_x", "velocity_y", "surface", "momentum_x", "momentum_y".
struct NamedField {
  std::string name;
  FieldValues values;
};

struct ProbeSample {
  double depth = 0.0;       // [m]
  double velocity_x = 0.0;  // [m/s]
  double velocity_y = 0.0;  // [m/s]
};

/// Where the frame of an object lies in the scene: a point p of it is at position + rotation p.
struct ObjectPose {
  std::array<double, 3> position{0.0, 0.0, 0.0};       // [m]
  std::array<double, 4> rotation{1.0, 0.0, 0.0, 0.0};  // unit quaternion w, x, y, z
  bool present = false;                                // between its start and its end
};

/// The particles as they are drawn. Their number is that of the cells of the grid J, in every frame.
struct ParticleFrame {
  std::vector<double> position;       // [m] x, y, z of each, at the surface or below it (eq. 33)
  std::vector<std::int64_t> id;       // stays with a particle as long as it lives; no two ever have the same
  std::vector<std::uint8_t> visible;  // 0: in sand too thin, or below the ground
};

/// A snapshot: owns its data, so that a sink may keep it while the solver goes on.
struct Frame {
  std::int64_t index = 0;
  FrameStatistics statistics;
  std::vector<NamedField> fields;       // the requested ones only; empty if output.frames is false
  std::vector<ProbeSample> probes;      // in the order of scene.output.probes
  std::vector<ObjectPose> objects;      // those that are coupled, in the order of the scene
  ParticleFrame particles;              // empty without scene.particles
  std::vector<double> fronts;           // [m] largest x with depth > reference.front_depths[k]; NaN: none
  std::vector<double> reference_depth;  // nx values if an exact solution is valid now (1-D), else empty
  double reference_tip = 0.0;           // [m] exact position of the tip now; NaN if unknown
};

/// Fields known once, at the start.
struct StaticFields {
  FieldValues bed{};  // [m] ny * nx; empty where the terrain is flat
};

/// Fields known once, at the end.
struct FinalFields {
  FieldValues max_depth, max_speed, arrival_time;  // empty unless output.maxima; arrival NaN: never
};

/// Receives what a run produces. Calls come in this order: begin, frame..., end. Each may throw (OutputError).
class Sink {
 public:
  virtual ~Sink() = default;
  virtual void begin(const Scene& scene, const StaticFields& fields) = 0;
  virtual void frame(Frame frame) = 0;
  virtual void end(const FinalFields& fields) = 0;
};

}  // namespace sandsim
