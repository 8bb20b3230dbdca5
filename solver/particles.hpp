// The grid J of the particles (section 6.1), and what a run of theirs goes on from.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "solver/report.hpp"
#include "solver/scene.hpp"

namespace sandsim {

/// Sand thinner than this part of the grid's spacing shows no particles, unless a scene says otherwise; the paper's
/// contour of the sand's surface lies at the same depth (section 7.2).
inline constexpr double thinnest_shown = 0.1;

/// The grid J: `refinement` cells of it fit along a side of the sand's cells, and every cell holds one particle. Cell
/// (s, t, d) has the number (d rows + t) columns + s.
struct ParticleGrid {
  int columns = 0, rows = 0, layers = 0;
  int refinement = 1;

  ParticleGrid() = default;
  ParticleGrid(const Grid& grid, const Particles& particles);

  std::int64_t count() const { return static_cast<std::int64_t>(columns) * rows * layers; }
};

/// 0 without particles.
std::int64_t particle_count(const Grid& grid, const std::optional<Particles>& particles);

/// Bytes of a particle in a frame: its position, id and visibility.
inline constexpr std::int64_t particle_frame_bytes = 3 * sizeof(double) + sizeof(std::int64_t) + sizeof(std::uint8_t);

/// All that is needed to go on moving particles bit for bit.
struct ParticleArrays {
  std::vector<float> offset_x, offset_y;      // one a particle, in cells of J from its cell's corner: [0, 1)
  std::vector<std::int64_t> id;               // one a particle
  std::vector<float> velocity_x, velocity_y;  // ny * nx [m/s] of the sand at the last move
  ParticleReport report;
};

}  // namespace sandsim
