// What a scene says of its time steps.
#pragma once

#include "solver/backend.hpp"
#include "solver/scene.hpp"
#include "solver/stepping.hpp"

namespace sandsim {

/// The rules by which steps are chosen; the time of the next frame is left open. `first_step` [s] is the largest stable
/// one of the initial state.
StepRules step_rules(const Scene& scene, const BackendConfig& config, double first_step);

}  // namespace sandsim
