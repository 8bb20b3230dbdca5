// The scene's terrain, sand and material turned into arrays on the grid.
#pragma once

#include <string>
#include <vector>

#include "solver/report.hpp"
#include "solver/scene.hpp"

namespace sandsim {

/// ny * nx arrays, x fastest. Arrays of size 1 hold one value for the whole grid; `bed` is empty on flat terrain.
struct InitialState {
  std::vector<double> bed;                   // [m]
  std::vector<double> depth;                 // [m]
  std::vector<double> friction_coefficient;  // [-] size 1 or ny * nx
  std::vector<double> hbar_scale;            // [-] alpha in hbar = min(alpha h, cap); size 1 or ny * nx
  std::vector<double> hbar_cap;              // [m] size 1 or ny * nx; 1e30 where there is no cap
  std::vector<double> momentum_x{};          // [m^2/s] empty if all sand is at rest
  std::vector<double> momentum_y{};          // [m^2/s] likewise
  ReleaseReport release{};
  std::vector<std::string> warnings{};  // of sand that the run does not start with
};

/// Rasters go onto the grid as resample.hpp says: depths of sand by spread(), all others by resample().
/// Throws SceneError if a raster has no data inside the grid, or depths are negative or not finite.
InitialState build_initial_state(const Scene& scene);

}  // namespace sandsim
