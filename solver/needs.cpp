#include "solver/needs.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "solver/backend_config.hpp"
#include "solver/backends/expected_bytes.hpp"
#include "solver/particles.hpp"
#include "solver/terrain.hpp"

namespace sandsim {
namespace {

/// Frames that a run holds beside its state: one that waits, one that is being written, and the one before.
constexpr double frames_held = 3.0;

int map_count(const Sand& sand) {
  const auto is_map = [](const ScalarMap& value) { return std::holds_alternative<double>(value) ? 0 : 1; };
  const ScalarMap uniform = 0.0;
  return is_map(sand.friction_angle.value_or(uniform)) + is_map(sand.friction_coefficient.value_or(uniform)) +
         is_map(sand.hbar.scale) + is_map(sand.hbar.cap);
}

bool has_velocity(const Sand& sand) {
  return std::any_of(sand.initial.begin(), sand.initial.end(), [](const SandPart& part) {
    return std::visit([](const auto& shape) { return shape.velocity != SandVelocity{}; }, part);
  });
}

bool has_covers(const Scene& scene) {
  return std::any_of(scene.objects.begin(), scene.objects.end(), [](const KinematicObject& object) {
    return !object.is_terrain() && object.coupling != Coupling::drag;
  });
}

}  // namespace

double particle_number(const Grid& grid, const std::optional<Particles>& particles) {
  if (!particles) {
    return 0.0;
  }
  const double refinement = std::round(grid.spacing / particles->spacing);
  return refinement * grid.cells[0] * refinement * grid.cells[1] * particles->layers;
}

Needs needs_of(const Scene& scene) {
  const double cells = static_cast<double>(scene.grid.cells[0]) * scene.grid.cells[1];
  const double word = scene.numerics.precision == Precision::float32 ? 4.0 : 8.0;
  const double fields = static_cast<double>(output_field_names(scene).size());
  const double particle_frames =
      static_cast<double>(particle_frame_bytes) * particle_number(scene.grid, scene.particles);
  const bool bed = has_bed(scene);
  const int maps = map_count(scene.sand);

  Needs needs;
  needs.frames = FrameSchedule(scene.time).count();
  needs.particle_bytes = particle_state_bytes(scene.grid, scene.particles) + frames_held * particle_frames;
  needs.state_bytes = field_state_bytes(scene.grid, scene.numerics.precision,
                                        {bed, has_covers(scene), scene.output.maxima.has_value(), maps}) +
                      particle_state_bytes(scene.grid, scene.particles);
  const double initial = 1.0 + (bed ? 1.0 : 0.0) + maps + (has_velocity(scene.sand) ? 2.0 : 0.0);
  needs.host_bytes = cells * (initial * sizeof(double) + frames_held * fields * word) + frames_held * particle_frames;
  const double once = (scene.output.maxima ? 3.0 + scene.output.maxima->pressure : 0.0) + (bed ? 1.0 : 0.0);
  constexpr double numbers_a_frame = 9 * 8;  // FrameStatistics
  const auto frames = static_cast<double>(needs.frames);
  needs.output_bytes = cells * word * (frames * fields + once) + frames * (numbers_a_frame + particle_frames);
  return needs;
}

}  // namespace sandsim
