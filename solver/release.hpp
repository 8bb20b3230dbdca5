// The sand that a scene starts with, on the grid.
#pragma once

#include "solver/grid_problems.hpp"
#include "solver/initial_state.hpp"
#include "solver/scene.hpp"
#include "solver/terrain.hpp"

namespace sandsim {

/// Depth, momentum and release of the state, and a warning for each part that lies partly outside the grid or on walls.
/// Shapes and polygons fill cells by the part of them that they cover, rasters by spread(): what they hold arrives on
/// the grid but for what lies outside or on walls.
void build_sand(const Scene& scene, const Ground& ground, InitialState& state, GridProblems& problems);

}  // namespace sandsim
