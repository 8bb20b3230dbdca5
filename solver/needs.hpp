// What a run of a scene takes, from its sizes alone.
#pragma once

#include <cstdint>

#include "solver/scene.hpp"

namespace sandsim {

struct Needs {
  std::int64_t frames = 0;
  double state_bytes = 0.0;     // the backend's, on its device: state, maps, particles
  double host_bytes = 0.0;      // initial values and frames on their way to the file
  double particle_bytes = 0.0;  // what particles take of these
  double output_bytes = 0.0;    // of series.h5, uncompressed

  double memory_bytes() const { return state_bytes + host_bytes; }  // on the CPU
};

/// Allocates nothing of the grid's size.
Needs needs_of(const Scene& scene);

/// The most cells of a grid, and of particles: what numbers of 32 bits count.
inline constexpr double most_cells = 2147483648.0;

/// As a double, since the grid may be far too large.
double particle_number(const Grid& grid, const std::optional<Particles>& particles);

}  // namespace sandsim
