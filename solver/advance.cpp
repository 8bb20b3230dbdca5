#include <algorithm>

#include "solver/object_stage.hpp"
#include "solver/stage_timer.hpp"

namespace sandsim {
namespace {

/// Rain during the planned step. [m^3]
double rain(Backend& backend, const std::vector<SandRain>& rains, const StepLoop& loop, StageReport& stage) {
  double volume = 0.0;
  for (const SandRain& rain : rains) {
    const double open = std::min(loop.time + loop.step, rain.end) - std::max(loop.time, rain.start);
    if (open > 0.0) {
      StageTimer timer(stage, 0.0);
      volume += backend.rain(rain, open);
    }
  }
  return volume;
}

}  // namespace

void advance_step_by_step(Backend& backend, const BackendConfig& config, StepLoop& loop, const StepRules& rules,
                          std::int64_t most, const LoopStages& stages) {
  for (std::int64_t done = 0; done < most && loop.halt == Halt::none; ++done) {
    StepOutcome outcome;
    {
      StageTimer timer(*stages.step, backend.bytes_per_step());
      outcome = backend.step(loop.step);
    }
    if (stages.sources != nullptr) {
      loop.volume_in += rain(backend, config.rains, loop, *stages.sources);
    }
    if (!config.objects.empty()) {
      StageTimer timer(*stages.objects, 0.0);
      couple_objects(backend, config.objects, loop, *stages.object_reports, outcome);
    }
    loop.finish(rules, outcome);
    if (config.maxima) {
      StageTimer timer(*stages.maxima, 1.5 * backend.bytes_per_step());
      backend.update_maxima(loop.time);
    }
    if (loop.halt == Halt::none) {
      loop.plan(rules, std::min(backend.stable_step(), object_step(config.objects, loop.time, config)));
    }
  }
}

}  // namespace sandsim
