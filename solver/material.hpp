// Friction and the depth of the dilute layer on the grid.
#pragma once

#include "solver/grid_problems.hpp"
#include "solver/initial_state.hpp"
#include "solver/scene.hpp"
#include "solver/terrain.hpp"

namespace sandsim {

/// The friction coefficient and hbar of the state. Maps of angles are averaged as angles. On walls, where no sand
/// comes, rasters need no data.
void build_material(const Scene& scene, const Ground& ground, InitialState& state, GridProblems& problems);

}  // namespace sandsim
