#include "solver/step_rules.hpp"

#include <algorithm>
#include <cmath>

#include "solver/object_stage.hpp"

namespace sandsim {
namespace {

/// The shortest step of a scene that does not say: a collapse is told from a long run of short steps by where the steps
/// began. [s]
double default_minimum_step(const TimeControl& time, double first_step) {
  return std::min(1e-9 * time.end, 1e-6 * first_step);
}

}  // namespace

StepRules step_rules(const Scene& scene, const BackendConfig& config, double first_step) {
  StepRules rules;
  const TimeControl& time = scene.time;
  rules.fixed_step = time.mode == TimeMode::fixed ? time.step : 0.0;
  rules.subcycle = time.subcycle;
  rules.minimum_step = time.minimum_step.value_or(default_minimum_step(time, first_step));
  rules.rain_step = HUGE_VAL;
  rules.rain_end = -HUGE_VAL;
  rules.objects_end = objects_change_until(config.objects);
  for (const SandRain& rain : config.rains) {
    // A step may neither pile up more than a tenth of a spacing nor outlast a fall over one spacing: sand on a dry
    // bed has no wave speed yet that would bound the step.
    const double dx = scene.grid.spacing;
    const double fall = scene.gravity > 0.0 ? std::sqrt(dx / scene.gravity) : time.frame_interval;
    rules.rain_step = std::min({rules.rain_step, 0.1 * dx / rain.rate, fall});
    rules.rain_end = std::max(rules.rain_end, rain.end);
  }
  return rules;
}

}  // namespace sandsim
