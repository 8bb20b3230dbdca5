#include <algorithm>
#include <cmath>

#include "solver/backend_config.hpp"
#include "solver/particles.hpp"
#include "solver/simulation.hpp"

namespace sandsim {

std::vector<std::string> stage_names(const Scene& scene) {
  std::vector<std::string> names{"step"};
  if (!scene.sand.sources.empty()) {
    names.push_back("sources");
  }
  const auto is_coupled = [](const KinematicObject& object) { return !object.is_terrain(); };
  if (std::any_of(scene.objects.begin(), scene.objects.end(), is_coupled)) {
    names.push_back("objects");
  }
  if (scene.output.maxima) {
    names.push_back("maxima");
  }
  if (scene.particles) {
    names.push_back("particles");
  }
  names.push_back("frames");
  return names;
}

Plan plan(const Scene& scene) {
  const InitialState initial = build_initial_state(scene);
  const auto backend = make_backend(backend_config(scene, 0), initial, Device::cpu);
  const FrameSchedule schedule(scene.time);
  Plan plan;
  plan.stages = stage_names(scene);
  plan.release = initial.release, plan.warnings = initial.warnings;
  plan.memory_bytes = backend->memory_bytes();
  plan.first_step = backend->stable_step();
  const double step = scene.time.mode == TimeMode::fixed ? scene.time.step : plan.first_step;
  plan.frames = schedule.count();
  plan.predicted_steps =
      std::isfinite(step) ? static_cast<std::int64_t>(std::ceil(scene.time.end / step)) : plan.frames;
  const std::int64_t word = scene.numerics.precision == Precision::float32 ? 4 : 8;
  const auto cells = static_cast<std::int64_t>(scene.grid.cell_count());
  const std::int64_t once =
      (scene.output.maxima ? 3 + scene.output.maxima->pressure : 0) + (initial.bed.empty() ? 0 : 1);
  constexpr std::int64_t numbers_a_frame = 9 * 8;  // FrameStatistics
  plan.output_bytes =
      cells * word * (plan.frames * static_cast<std::int64_t>(output_field_names(scene).size()) + once) +
      plan.frames * (numbers_a_frame + particle_frame_bytes * particle_count(scene.grid, scene.particles));
  return plan;
}

}  // namespace sandsim
