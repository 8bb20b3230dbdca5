#include "solver/object_stage.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace sandsim {
namespace {

/// Cells that an object may move in a step: what it has newly overlapped lies beside cells that were free.
constexpr double cells_a_step = 0.5;

}  // namespace

bool ObjectStep::is_still() const {
  const auto at_rest = [](const objects::RigidState& state) {
    return objects::length(state.velocity) == 0.0 && objects::length(state.angular_velocity) == 0.0;
  };
  return at_rest(before) && at_rest(after) && before.pose == after.pose;
}

SharedObjects coupled_objects(const Scene& scene) {
  SharedObjects made;
  for (const KinematicObject& object : scene.objects) {
    if (!object.is_terrain()) {
      made.push_back(std::make_shared<objects::Object>(object, scene.grid.spacing));
    }
  }
  return made;
}

bool any_covers(const SharedObjects& objects) {
  return std::any_of(objects.begin(), objects.end(),
                     [](const auto& object) { return object->coupling() != Coupling::drag; });
}

double objects_change_until(const SharedObjects& objects) {
  double until = -HUGE_VAL;
  for (const auto& object : objects) {
    until = std::max(until, object->changes_until());
  }
  return until;
}

double object_step(const SharedObjects& objects, double time, const BackendConfig& config) {
  double step = HUGE_VAL;
  for (const auto& object : objects) {
    if (time >= object->changes_until()) {
      continue;
    }
    // As long as a fall over one cell: a motion that begins within it is met before it has gone far.
    const double dx = config.grid.spacing;
    double own = config.gravity > 0.0 ? std::sqrt(dx / config.gravity) : HUGE_VAL;
    if (time < object->start()) {
      own = std::max(object->start() - time, 1e-3 * own);
    }
    for (const double then : {time, time + std::min(own, step)}) {
      const double speed = object->is_present(then) ? object->top_speed(object->at(then)) : 0.0;
      own = speed > 0.0 ? std::min(own, cells_a_step * dx / speed) : own;
    }
    step = std::min(step, own);
  }
  return step;
}

void couple_objects(Backend& backend, const SharedObjects& objects, const StepLoop& loop,
                    std::vector<ObjectReport>& reports, StepOutcome& outcome) {
  const double now = loop.time + loop.step;
  std::vector<ObjectStep> steps;
  for (std::size_t k = 0; k < objects.size(); ++k) {
    const objects::Object& object = *objects[k];
    const bool was_there = object.is_present(loop.time), is_there = object.is_present(now);
    if (was_there || is_there) {  // one that has just appeared has not moved yet
      const objects::RigidState after = object.at(now);
      steps.push_back({k, was_there ? object.at(loop.time) : after, after, !is_there});
    }
  }
  for (const ObjectStep& step : steps) {
    if (step.has_left && objects[step.object]->coupling() == Coupling::drag) {
      continue;  // it leaves nothing behind that would have to be uncovered
    }
    const auto begin = std::chrono::steady_clock::now();
    const ObjectEffect effect = backend.couple(step, steps);
    outcome.changed = outcome.changed || effect.changed;
    ObjectReport& report = reports[step.object];
    report.overlapped_volume = effect.overlapped_volume;
    report.displaced_volume += effect.displaced_volume;
    report.momentum[0] += effect.momentum[0], report.momentum[1] += effect.momentum[1];
    report.work += effect.work;
    report.deepest = std::max(report.deepest, effect.deepest);
    report.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }
}

}  // namespace sandsim
