#include "solver/backends/expected_bytes.hpp"

#include <cstdint>

#include "solver/errors.hpp"
#include "solver/particles.hpp"

namespace sandsim {
namespace {

std::string mebibytes(double bytes) {
  return std::to_string(static_cast<std::int64_t>(bytes / 1048576.0)) + " MiB";
}

double particle_bytes(const BackendConfig& config) {
  constexpr double one = 52.0 + particle_frame_bytes;  // where they are and where they go, and a frame of them
  return one * static_cast<double>(particle_count(config.grid, config.particles));
}

}  // namespace

double expected_bytes(const BackendConfig& config, const InitialState& initial) {
  const double word = config.numerics.precision == Precision::float32 ? 4.0 : 8.0;
  const double cells = static_cast<double>(config.grid.cell_count());
  double words = 6.0 + (initial.bed.empty() && !config.covers ? 0.0 : 1.0) + (config.maxima ? 3.0 : 0.0);
  for (const auto* map : {&initial.friction_coefficient, &initial.hbar_scale, &initial.hbar_cap}) {
    words += map->size() > 1 ? 1.0 : 0.0;
  }
  const double covers = config.covers ? word + sizeof(double) : 0.0;
  return cells * (words * word + covers) + particle_bytes(config);
}

void require_bytes(const BackendConfig& config, double needed, double present, const std::string& place) {
  if (needed <= present) {
    return;
  }
  const double particles = particle_bytes(config);
  const bool mostly_particles = particles > 0.5 * needed;
  throw DeviceError("the scene needs " + mebibytes(needed) + " of memory" +
                    (mostly_particles ? ", " + mebibytes(particles) + " of it for particles," : "") + " and " + place +
                    " has " + mebibytes(present) + ". " +
                    (mostly_particles ? "Use a larger particles.spacing, or fewer particles.layers?"
                                      : "Use fewer cells, or numerics.precision: float32?"));
}

}  // namespace sandsim
