#include "solver/particles.hpp"

#include <cmath>

namespace sandsim {

ParticleGrid::ParticleGrid(const Grid& grid, const Particles& particles)
    : layers(particles.layers), refinement(static_cast<int>(std::lround(grid.spacing / particles.spacing))) {
  columns = grid.cells[0] * refinement;
  rows = grid.cells[1] * refinement;
}

}  // namespace sandsim
