// What is done to all particles of a run, one thread each: the particles enter claims on the cells of J, and then every
// cell takes in the particle whose claim is the best, or a new one.
#pragma once

#include <cstdint>
#include <limits>

#include "solver/backends/particles/laws.hpp"
#include "solver/backends/particles/sand_view.hpp"

namespace sandsim::particles {

inline constexpr int threads_a_block = 256;
/// The claim on a cell that no particle enters.
inline constexpr std::int64_t no_claim = INT64_MAX;

/// The particles, in the order of the cells of J.
struct ParticleView {
  Axis x, y;
  int layers = 1;
  int seed = 0;
  float *offset_x = nullptr, *offset_y = nullptr;
  std::int64_t *id = nullptr, *next_id = nullptr;
  float *moved_x = nullptr, *moved_y = nullptr;  // offsets in the cells that they enter
  std::int64_t* claims = nullptr;

  SANDSIM_HD std::int64_t count() const { return static_cast<std::int64_t>(x.cells) * y.cells * layers; }
};

/// The thread's number among all threads of the launch.
template <class Block>
SANDSIM_HD std::int64_t thread_number(const Block& block, int thread) {
  return static_cast<std::int64_t>(block.x()) * block.width() + thread;
}

/// The way that the sand has carried a particle in a whole move, at the centres of the sand's cells and in a ring of
/// ghost cells around them, in cells of J: the mean of the velocities now and at the last move, times `scale`.
struct WayKernel {
  static constexpr const char* doing = "find the ways of particles";
  static constexpr int most_threads = threads_a_block;
  SandView sand;
  const float *before_x, *before_y;  // velocities at the last move
  float scale;
  float *way_x, *way_y;
  float* longest;

  template <class Block>
  SANDSIM_HD void operator()(Block& block) const {
    block.each([&](int thread, int) {
      const std::int64_t k = thread_number(block, thread);
      const int width = sand.nx + 2;
      if (k >= static_cast<std::int64_t>(width) * (sand.ny + 2)) {
        return;
      }
      const Image i = image_of(static_cast<int>(k % width) - 1, sand.nx, sand.sides.x_min, sand.sides.x_max);
      const Image j = image_of(static_cast<int>(k / width) - 1, sand.ny, sand.sides.y_min, sand.sides.y_max);
      const std::int64_t cell = static_cast<std::int64_t>(j.index) * sand.nx + i.index;
      const float x = scale * (before_x[cell] + sand.velocity_x[cell]);
      const float y = scale * (before_y[cell] + sand.velocity_y[cell]);
      way_x[k] = i.momentum(x), way_y[k] = j.momentum(y);
      const float way = physics::maximum(physics::absolute(x), physics::absolute(y));
      if (way > 0.0f) {
        block.raise(longest, way);
      }
    });
  }
};

/// Moves every particle along its way, in `hops` of the midpoint rule, and enters its claim.
struct MoveKernel {
  static constexpr const char* doing = "move particles";
  static constexpr int most_threads = threads_a_block;
  ParticleView particles;
  int nx;  // of the sand
  const float *way_x, *way_y;
  int hops;
  std::int64_t* left;

  template <class Block>
  SANDSIM_HD void operator()(Block& block) const {
    block.each([&](int thread, int) {
      const std::int64_t k = thread_number(block, thread);
      if (k >= particles.count()) {
        return;
      }
      const std::int64_t row = k / particles.x.cells, layer = row / particles.y.cells;
      Place x{static_cast<int>(k - row * particles.x.cells), particles.offset_x[k]};
      Place y{static_cast<int>(row - layer * particles.y.cells), particles.offset_y[k]};
      if (carry(x, y)) {
        particles.moved_x[k] = x.offset, particles.moved_y[k] = y.offset;
        const std::int64_t to = (layer * particles.y.cells + y.cell) * particles.x.cells + x.cell;
        block.lower(&particles.claims[to], claim_of(particles.id[k], k));
      } else {
        block.add(left, 1);
      }
    });
  }

 private:
  /// False if the particle has left through an open side.
  SANDSIM_HD bool carry(Place& x, Place& y) const {
    const float part = 1.0f / static_cast<float>(hops);
    for (int hop = 0; hop < hops; ++hop) {
      Place middle_x = x, middle_y = y;
      float step_x, step_y;
      way_at(x, y, step_x, step_y);
      if (step_x == 0.0f && step_y == 0.0f) {
        return true;  // it rests for the whole move
      }
      shift(middle_x, 0.5f * part * step_x), shift(middle_y, 0.5f * part * step_y);
      if (bring_inside(middle_x, particles.x) && bring_inside(middle_y, particles.y)) {
        way_at(middle_x, middle_y, step_x, step_y);
      }
      shift(x, part * step_x), shift(y, part * step_y);
      if (!bring_inside(x, particles.x) || !bring_inside(y, particles.y)) {
        return false;
      }
    }
    return true;
  }
  SANDSIM_HD void way_at(const Place& x, const Place& y, float& step_x, float& step_y) const {
    const Stencil sx = stencil(x, particles.x.refinement), sy = stencil(y, particles.y.refinement);
    const int width = nx + 2;
    const auto at = [&](const float* way) {
      return interpolate(sx, sy, [&](int i, int j) { return way[static_cast<std::int64_t>(j + 1) * width + i + 1]; });
    };
    step_x = at(way_x), step_y = at(way_y);
  }
};

/// Every cell takes in the particle with the best claim, or a new one where there is no claim.
struct SettleKernel {
  static constexpr const char* doing = "settle particles";
  static constexpr int most_threads = threads_a_block;
  ParticleView particles;
  std::int64_t move;  // counted from 1; 0: all are new
  std::int64_t* born;

  template <class Block>
  SANDSIM_HD void operator()(Block& block) const {
    block.each([&](int thread, int) {
      const std::int64_t cell = thread_number(block, thread);
      if (cell >= particles.count()) {
        return;
      }
      const std::int64_t claim = particles.claims[cell];
      if (claim == no_claim) {
        const std::int64_t id = id_of(move, cell);
        const Offsets offsets = birth_offsets(id, particles.seed);
        particles.offset_x[cell] = offsets.x, particles.offset_y[cell] = offsets.y;
        particles.next_id[cell] = id;
        block.add(born, 1);
        return;
      }
      const std::int64_t from = claimant(claim);
      particles.offset_x[cell] = particles.moved_x[from], particles.offset_y[cell] = particles.moved_y[from];
      particles.next_id[cell] = particles.id[from];
      particles.claims[cell] = no_claim;
    });
  }
};

/// Places the particles under the surface (eq. 33) and hides those that are not in the sand.
struct ShowKernel {
  static constexpr const char* doing = "place particles";
  static constexpr int most_threads = threads_a_block;
  ParticleView particles;
  SandView sand;
  double origin_x, origin_y;  // [m]
  double spacing;             // [m] of J
  float hide_below;           // [m]
  float* position;            // [m] x, y, z of each
  std::uint8_t* visible;

  template <class Block>
  SANDSIM_HD void operator()(Block& block) const {
    block.each([&](int thread, int) {
      const std::int64_t k = thread_number(block, thread);
      if (k >= particles.count()) {
        return;
      }
      const std::int64_t row = k / particles.x.cells, layer = row / particles.y.cells;
      const Place x{static_cast<int>(k - row * particles.x.cells), particles.offset_x[k]};
      const Place y{static_cast<int>(row - layer * particles.y.cells), particles.offset_y[k]};
      const Stencil sx = stencil(x, particles.x.refinement), sy = stencil(y, particles.y.refinement);
      const auto at = [&](const float* values) {
        return interpolate(sx, sy, [&](int i, int j) {
          const int ii = image_of(i, sand.nx, sand.sides.x_min, sand.sides.x_max).index;
          const int jj = image_of(j, sand.ny, sand.sides.y_min, sand.sides.y_max).index;
          return values[static_cast<std::int64_t>(jj) * sand.nx + ii];
        });
      };
      const float inside = birth_offsets(particles.id[k], particles.seed).z;
      const double below = spacing * (static_cast<double>(layer) + static_cast<double>(inside));
      const std::int64_t cell =
          static_cast<std::int64_t>(y.cell / particles.y.refinement) * sand.nx + x.cell / particles.x.refinement;
      position[3 * k] = static_cast<float>(origin_x + spacing * (x.cell + static_cast<double>(x.offset)));
      position[3 * k + 1] = static_cast<float>(origin_y + spacing * (y.cell + static_cast<double>(y.offset)));
      position[3 * k + 2] = static_cast<float>(static_cast<double>(at(sand.surface)) - below);
      visible[k] = sand.depth[cell] >= hide_below && below <= static_cast<double>(at(sand.depth)) ? 1 : 0;
    });
  }
};

}  // namespace sandsim::particles
