#include "solver/backends/expected_bytes.hpp"

#include <cstdint>

#include "solver/errors.hpp"
#include "solver/needs.hpp"
#include "solver/particles.hpp"

namespace sandsim {
namespace {

std::string mebibytes(double bytes) {
  return std::to_string(static_cast<std::int64_t>(bytes / 1048576.0)) + " MiB";
}

double cell_count(const Grid& grid) {
  return static_cast<double>(grid.cells[0]) * grid.cells[1];
}

}  // namespace

double field_state_bytes(const Grid& grid, Precision precision, const FieldArrays& arrays) {
  const double word = precision == Precision::float32 ? 4.0 : 8.0;
  const double words =
      6.0 + (arrays.bed || arrays.covers ? 1.0 : 0.0) + (arrays.maxima ? 3.0 : 0.0) + static_cast<double>(arrays.maps);
  return cell_count(grid) * (words * word + (arrays.covers ? word + sizeof(double) : 0.0));
}

double particle_state_bytes(const Grid& grid, const std::optional<Particles>& particles) {
  constexpr double one = 52.0 + particle_frame_bytes;  // where they are and where they go, and a frame of them
  constexpr double cell = 36.0;                        // ways; velocities now and before, depth, surface
  return particles ? one * particle_number(grid, particles) + cell * cell_count(grid) : 0.0;
}

double expected_bytes(const BackendConfig& config, const InitialState& initial) {
  FieldArrays arrays{!initial.bed.empty(), config.covers, config.maxima, 0};
  for (const auto* map : {&initial.friction_coefficient, &initial.hbar_scale, &initial.hbar_cap}) {
    arrays.maps += map->size() > 1 ? 1 : 0;
  }
  return field_state_bytes(config.grid, config.numerics.precision, arrays) +
         particle_state_bytes(config.grid, config.particles);
}

void require_bytes(const BackendConfig& config, double needed, double present, const std::string& place) {
  if (needed <= present) {
    return;
  }
  const double particles = particle_state_bytes(config.grid, config.particles);
  const bool mostly_particles = particles > 0.5 * needed;
  throw DeviceError("the scene needs " + mebibytes(needed) + " of memory" +
                    (mostly_particles ? ", " + mebibytes(particles) + " of it for particles," : "") + " and " + place +
                    " has " + mebibytes(present) + ". " +
                    (mostly_particles ? "Use a larger particles.spacing, or fewer particles.layers?"
                                      : "Use fewer cells, or numerics.precision: float32?"));
}

}  // namespace sandsim
