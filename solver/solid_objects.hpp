// Solid obstacles: kinematic objects that stand still and that no sand enters. They are part of the terrain.
#pragma once

#include "solver/initial_state.hpp"

namespace sandsim {

/// Raises the bed to the top of the solid objects where they stand on the ground, and takes away the sand there. The
/// bed may be empty (flat) before; it stays so without solid objects.
void raise_solid_objects(const Scene& scene, InitialState& state);

}  // namespace sandsim
