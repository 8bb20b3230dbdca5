#include "solver/initial_state.hpp"

#include <numeric>

#include "solver/grid_problems.hpp"
#include "solver/material.hpp"
#include "solver/release.hpp"
#include "solver/solid_objects.hpp"
#include "solver/terrain.hpp"

namespace sandsim {
namespace {

double volume(const Grid& grid, const std::vector<double>& depth) {
  return std::accumulate(depth.begin(), depth.end(), 0.0) * grid.spacing * grid.spacing;
}

/// Solid objects raise the bed, and the sand where they stand is gone with its momentum.
void place_solid_objects(const Scene& scene, InitialState& state) {
  const double before = state.release.grid_volume;
  raise_solid_objects(scene, state);
  state.release.grid_volume = volume(scene.grid, state.depth);
  state.release.blocked_volume += before - state.release.grid_volume;
  for (std::vector<double>* momentum : {&state.momentum_x, &state.momentum_y}) {
    for (std::size_t cell = 0; cell < momentum->size(); ++cell) {
      (*momentum)[cell] = state.depth[cell] > 0.0 ? (*momentum)[cell] : 0.0;
    }
  }
}

}  // namespace

InitialState build_initial_state(const Scene& scene) {
  GridProblems problems(scene.grid);
  InitialState state;
  const Ground ground = build_ground(scene, problems);
  build_sand(scene, ground, state, problems);
  build_material(scene, ground, state, problems);
  problems.throw_if_any();
  state.bed = ground.bed;
  state.release.grid_volume = volume(scene.grid, state.depth);
  raise_walls(scene, ground, state);
  place_solid_objects(scene, state);
  return state;
}

}  // namespace sandsim
