#include <algorithm>
#include <cmath>

#include "solver/backend_config.hpp"
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
  Plan plan;
  plan.release = initial.release, plan.warnings = initial.warnings;
  plan.first_step = backend->stable_step();
  const double step = scene.time.mode == TimeMode::fixed ? scene.time.step : plan.first_step;
  plan.predicted_steps = std::isfinite(step) ? static_cast<std::int64_t>(std::ceil(scene.time.end / step))
                                             : FrameSchedule(scene.time).count();
  const auto east = static_cast<std::size_t>(scene.grid.cells[0] - 1);
  const std::size_t north = scene.grid.cell_count() - 1 - east;
  const std::size_t corners[] = {0, east, north, north + east};
  for (std::size_t k = 0; k < 4; ++k) {
    plan.corner_beds[k] = initial.bed.empty() ? 0.0 : initial.bed[corners[k]];
  }
  return plan;
}

}  // namespace sandsim
