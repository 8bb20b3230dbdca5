#include "solver/backends/expected_bytes.hpp"

#include "solver/particles.hpp"

namespace sandsim {

double expected_bytes(const BackendConfig& config, const InitialState& initial) {
  const double word = config.numerics.precision == Precision::float32 ? 4.0 : 8.0;
  const double cells = static_cast<double>(config.grid.cell_count());
  double words = 6.0 + (initial.bed.empty() && !config.covers ? 0.0 : 1.0) + (config.maxima ? 3.0 : 0.0);
  for (const auto* map : {&initial.friction_coefficient, &initial.hbar_scale, &initial.hbar_cap}) {
    words += map->size() > 1 ? 1.0 : 0.0;
  }
  const double covers = config.covers ? word + sizeof(double) : 0.0;
  constexpr double particle = 52.0 + 21.0;  // where they are and where they go, and a frame of them [B]
  const double particles =
      config.particles ? particle * static_cast<double>(ParticleGrid(config.grid, *config.particles).count()) : 0.0;
  return cells * (words * word + covers) + particles;
}

}  // namespace sandsim
