// The scene's terrain on the grid.
#pragma once

#include <vector>

#include "solver/grid_problems.hpp"
#include "solver/initial_state.hpp"
#include "solver/scene.hpp"

namespace sandsim {

/// The bed, and the cells that are a wall because the terrain has no data there (`nodata: wall`).
struct Ground {
  std::vector<double> bed;      // [m] ny * nx; empty on flat terrain; 0 on walls
  std::vector<char> is_wall{};  // ny * nx; empty without walls

  double bed_at(std::size_t cell) const { return bed.empty() ? 0.0 : bed[cell]; }
  bool wall_at(std::size_t cell) const { return !is_wall.empty() && is_wall[cell] != 0; }
};

/// Whether the scene's terrain is more than level ground at 0 m, which needs no array.
bool has_bed(const Scene& scene);

/// The bed, in the run's precision. Where a raster has no data the cell is a problem, a wall, or takes the nearest
/// value of that raster. Sources on walls are a problem.
Ground build_ground(const Scene& scene, GridProblems& problems);

/// Raises the bed of walls to where no sand comes: above all ground and sand at the start by all that sand can fall,
/// and by what sources and objects can heap up. Sand that falls from the highest point to the lowest has the energy to
/// come back to that height, not to twice it.
void raise_walls(const Scene& scene, const Ground& ground, InitialState& state);

/// 1 / cos of the bed's slope in a cell, from central differences of the bed; one-sided at the grid's edge and beside
/// walls.
double slope_secant(const Ground& ground, const Grid& grid, int i, int j);

}  // namespace sandsim
