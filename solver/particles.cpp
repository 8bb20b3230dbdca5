#include "solver/particles.hpp"

#include <cmath>

namespace sandsim {

ParticleGrid::ParticleGrid(const Grid& grid, const Particles& particles)
    : layers(particles.layers), refinement(static_cast<int>(std::lround(grid.spacing / particles.spacing))) {
  columns = grid.cells[0] * refinement;
  rows = grid.cells[1] * refinement;
}

std::int64_t particle_count(const Grid& grid, const std::optional<Particles>& particles) {
  return particles ? ParticleGrid(grid, *particles).count() : 0;
}

}  // namespace sandsim
