// Solid objects that stand still: they are part of the terrain.
#pragma once

#include "solver/initial_state.hpp"

namespace sandsim {

/// Raises the bed to the top of such objects where they stand on the ground, and takes away the sand there. The
/// bed may be empty (flat) before; it stays so without solid objects.
void raise_solid_objects(const Scene& scene, InitialState& state);

}  // namespace sandsim
