// The kinematic objects of a run between steps: where they are, how far they may move, what they do to the sand.
#pragma once

#include <memory>
#include <vector>

#include "solver/backend.hpp"
#include "solver/objects/object.hpp"

namespace sandsim {

using SharedObjects = std::vector<std::shared_ptr<const objects::Object>>;

/// The objects of a scene that are coupled in every step: all but those that are terrain.
SharedObjects coupled_objects(const Scene& scene);

/// Some object is bed for the flow where it covers sand: coupling `displace` or `solid`.
bool any_covers(const SharedObjects& objects);

/// No object moves, comes or goes after this time; -infinite if none ever does. [s]
double objects_change_until(const SharedObjects& objects);

/// How long a step from `time` may be: no present object moves further than half a cell in it, none appears in its
/// middle, and it is short enough for objects that are about to move to be seen. Infinite without moving objects. [s]
double object_step(const SharedObjects& objects, double time, const BackendConfig& config);

/// Couples the objects that are there at the end of the step that begins at loop.time and takes loop.step, and those
/// that have left in it; adds what happened to the reports, one an object, and to the step's outcome.
void couple_objects(Backend& backend, const SharedObjects& objects, const StepLoop& loop,
                    std::vector<ObjectReport>& reports, StepOutcome& outcome);

}  // namespace sandsim
