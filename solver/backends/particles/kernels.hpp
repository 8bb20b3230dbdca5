// What is done to all particles of a run, one thread each: the particles enter claims on the cells of J, and then every
// cell takes in the particle whose claim is the best, or a new one.
#pragma once

#include <cstdint>

#include "solver/backends/particles/laws.hpp"
#include "solver/backends/particles/sand_view.hpp"
#include "solver/particles.hpp"

namespace sandsim::particles {

inline constexpr int threads_a_block = 256;
/// The claim on a cell that no particle enters.
inline constexpr std::int64_t no_claim = INT64_MAX;

/// The particles, in the order of the cells of J.
struct ParticleView {
  ParticleGrid grid;
  Axis x, y;  // of the sand's grid
  int seed = 0;
  float *offset_x = nullptr, *offset_y = nullptr;
  std::int64_t* id = nullptr;
  // Of those that are being moved, by the cell that they come from: the cell that they enter, and where in it.
  int* entered = nullptr;  // -1: none, it has left the grid
  float *moved_x = nullptr, *moved_y = nullptr;
  std::int64_t* moved_id = nullptr;
  // By the cell that they enter: the best claim, and the best of those that were pushed there from a full cell.
  std::int64_t *claims = nullptr, *pushed_claims = nullptr;

  SANDSIM_HD std::int64_t cell(int column, int row, int layer) const {
    return (static_cast<std::int64_t>(layer) * grid.rows + row) * grid.columns + column;
  }
};

/// Cells of J that a launch goes over: columns and rows, in all layers. A block has threads along a row.
struct ParticleBox {
  int column0 = 0, column1 = 0, row0 = 0, row1 = 0;

  int columns() const { return column1 - column0; }
  int rows() const { return row1 - row0; }
};

/// visit(column, row, layer) of the thread's particle.
template <class Block, class Visit>
SANDSIM_HD void each_particle(Block& block, const ParticleBox& box, const Visit& visit) {
  const int rows = box.row1 - box.row0;
  const int layer = block.x() / rows, row = box.row0 + (block.x() - layer * rows);
  const int first = box.column0 + block.y() * block.width();
  block.each([&](int thread, int) {
    if (first + thread < box.column1) {
      visit(first + thread, row, layer);
    }
  });
}

/// [cells of the sand]
struct Way {
  float x, y;
};

/// What a move has to reckon with.
struct MoveExtent {
  float longest = 0.0f;         // way [cells of the sand]
  std::int64_t i0, i1, j0, j1;  // the moving cells are i0 .. i1, j0 .. j1; of the last numbers, the negatives
};

/// The way that the sand has carried particles in a whole move, at the centres of the sand's cells and in a ring of
/// ghost cells around them, in cells of the sand: the mean of the velocities now and at the last move, times `scale`.
struct WayKernel {
  static constexpr const char* doing = "find the ways of particles";
  static constexpr int most_threads = threads_a_block;
  SandView sand;
  const float *before_x, *before_y;  // velocities at the last move
  float scale;
  Way* ways;
  MoveExtent* extent;

  template <class Block>
  SANDSIM_HD void operator()(Block& block) const {
    const int row = block.x(), width = sand.nx + 2;
    const Image j = image_of(row - 1, sand.ny, sand.sides.y_min, sand.sides.y_max);
    block.each([&](int thread, int) {
      const int column = block.y() * block.width() + thread;
      if (column >= width) {
        return;
      }
      const Image i = image_of(column - 1, sand.nx, sand.sides.x_min, sand.sides.x_max);
      const std::int64_t cell = static_cast<std::int64_t>(j.index) * sand.nx + i.index;
      const float x = scale * (before_x[cell] + sand.velocity_x[cell]);
      const float y = scale * (before_y[cell] + sand.velocity_y[cell]);
      const std::int64_t k = static_cast<std::int64_t>(row) * width + column;
      ways[k] = {i.momentum(x), j.momentum(y)};
      const float way = physics::maximum(physics::absolute(x), physics::absolute(y));
      if (way > 0.0f) {
        // Few cells still find a bound to move: looking first spares the others their turn at the same number.
        const auto lower = [&](std::int64_t* bound, std::int64_t value) {
          if (value < block.read(bound)) {
            block.lower(bound, value);
          }
        };
        if (way > block.read(&extent->longest)) {
          block.raise(&extent->longest, way);
        }
        lower(&extent->i0, column - 1), lower(&extent->i1, 1 - column);
        lower(&extent->j0, row - 1), lower(&extent->j1, 1 - row);
      }
    });
  }
};

/// Moves every particle along its way, in hops of the midpoint rule, and enters its claim.
struct MoveKernel {
  static constexpr const char* doing = "move particles";
  static constexpr int most_threads = threads_a_block;
  /// A hop is at most this long, in cells of the sand: between their centres the velocity is bilinear.
  static constexpr float longest_hop = 1.0f;
  static constexpr float smallest_part = 1e-4f;  // of a move, however fast the sand
  ParticleView particles;
  ParticleBox box;
  const Way* ways;
  std::int64_t* left;

  template <class Block>
  SANDSIM_HD void operator()(Block& block) const {
    const int refinement = particles.grid.refinement;
    each_particle(block, box, [&](int column, int row, int layer) {
      const std::int64_t k = particles.cell(column, row, layer), id = particles.id[k];
      const Place from_x{column, particles.offset_x[k]}, from_y{row, particles.offset_y[k]};
      Place x = in_sand(from_x, refinement), y = in_sand(from_y, refinement);
      bool moved = false;
      particles.moved_id[k] = id;
      if (!carry(x, y, moved)) {
        particles.entered[k] = -1;
        block.add(left, 1);
        return;
      }
      const Place to_x = moved ? in_particles(x, refinement) : from_x;
      const Place to_y = moved ? in_particles(y, refinement) : from_y;
      particles.moved_x[k] = to_x.offset, particles.moved_y[k] = to_y.offset;
      const std::int64_t to = particles.cell(to_x.cell, to_y.cell, layer);
      particles.entered[k] = static_cast<int>(to);
      block.lower(&particles.claims[to], claim_of(id, k));
    });
  }

 private:
  /// False if the particle has left through an open side.
  SANDSIM_HD bool carry(Place& x, Place& y, bool& moved) const {
    float rest = 1.0f;  // of the move
    while (rest > 0.0f) {
      Way way = way_at(x, y);
      const float longest = physics::maximum(physics::absolute(way.x), physics::absolute(way.y));
      if (!(longest > 0.0f)) {
        return true;
      }
      moved = true;
      const float part = physics::minimum(rest, physics::maximum(longest_hop / longest, smallest_part));
      Place middle_x = x, middle_y = y;
      shift(middle_x, 0.5f * part * way.x), shift(middle_y, 0.5f * part * way.y);
      if (bring_inside(middle_x, particles.x) && bring_inside(middle_y, particles.y)) {
        way = way_at(middle_x, middle_y);
      }
      shift(x, part * way.x), shift(y, part * way.y);
      if (!bring_inside(x, particles.x) || !bring_inside(y, particles.y)) {
        return false;
      }
      rest -= part;
    }
    return true;
  }
  SANDSIM_HD Way way_at(const Place& x, const Place& y) const {
    const Stencil sx = stencil(x), sy = stencil(y);
    const std::int64_t width = particles.x.cells + 2;
    const Way* const below = ways + (sy.lower + 1) * width + sx.lower + 1;
    const Way* const above = below + width;
    return {interpolate(sx, sy, below[0].x, below[1].x, above[0].x, above[1].x),
            interpolate(sx, sy, below[0].y, below[1].y, above[0].y, above[1].y)};
  }
};

/// A particle that has lost its cell to another one is pushed into an empty cell beside it, the nearest first, so that
/// it need not vanish while a new one appears next to it. It enters a second claim there.
struct PushKernel {
  static constexpr const char* doing = "push particles aside";
  static constexpr int most_threads = threads_a_block;
  ParticleView particles;
  ParticleBox box;

  template <class Block>
  SANDSIM_HD void operator()(Block& block) const {
    each_particle(block, box, [&](int column, int row, int layer) {
      const std::int64_t k = particles.cell(column, row, layer);
      const std::int64_t entered = particles.entered[k], claim = claim_of(particles.moved_id[k], k);
      if (entered < 0 || particles.claims[entered] == claim) {
        return;
      }
      const float x = particles.moved_x[k], y = particles.moved_y[k];
      const std::int64_t in_layer = entered - particles.cell(0, 0, layer);
      const int to_row = static_cast<int>(in_layer / particles.grid.columns);
      const int to_column = static_cast<int>(in_layer % particles.grid.columns);
      for (int choice = 0; choice < 8; ++choice) {
        int beside_x, beside_y;
        choose(choice, x, y, beside_x, beside_y);
        if (is_empty(to_column + beside_x, to_row + beside_y, layer)) {
          particles.moved_x[k] = pushed(x, beside_x), particles.moved_y[k] = pushed(y, beside_y);
          block.lower(&particles.pushed_claims[particles.cell(to_column + beside_x, to_row + beside_y, layer)], claim);
          return;
        }
      }
    });
  }

 private:
  /// The cells around a place in a cell: beside the nearest edge, beside the other near one, across the corner between
  /// them; then the far sides.
  static SANDSIM_HD void choose(int choice, float x, float y, int& beside_x, int& beside_y) {
    const bool x_first = physics::absolute(x - 0.5f) > physics::absolute(y - 0.5f);
    // As factors on the way to the nearer edge: of the axis whose edge is nearer, and of the other one.
    const int first = choice == 1 || choice == 4 ? 0 : choice == 3 || choice == 6 || choice == 7 ? -1 : 1;
    const int second = choice == 0 || choice == 3 ? 0 : choice == 4 || choice == 5 || choice == 7 ? -1 : 1;
    beside_x = (x < 0.5f ? -1 : 1) * (x_first ? first : second);
    beside_y = (y < 0.5f ? -1 : 1) * (x_first ? second : first);
  }
  /// A cell that the launch goes over and no particle has entered by itself.
  SANDSIM_HD bool is_empty(int column, int row, int layer) const {
    return column >= box.column0 && column < box.column1 && row >= box.row0 && row < box.row1 &&
           particles.claims[particles.cell(column, row, layer)] == no_claim;
  }
  /// An offset in the cell `to` cells further: in its nearer half, ordered as before.
  static SANDSIM_HD float pushed(float offset, int to) {
    return to == 0 ? offset : 0.5f * offset + (to < 0 ? 0.5f : 0.0f);
  }
};

/// Every cell takes in the particle with the best claim, or a new one where there is no claim.
struct SettleKernel {
  static constexpr const char* doing = "settle particles";
  static constexpr int most_threads = threads_a_block;
  ParticleView particles;
  ParticleBox box;
  std::int64_t move;  // counted from 1; 0: all are new
  std::int64_t* born;

  template <class Block>
  SANDSIM_HD void operator()(Block& block) const {
    each_particle(block, box, [&](int column, int row, int layer) {
      const std::int64_t cell = particles.cell(column, row, layer);
      const std::int64_t first = particles.claims[cell];
      const std::int64_t claim = first != no_claim ? first : particles.pushed_claims[cell];
      particles.claims[cell] = particles.pushed_claims[cell] = no_claim;
      if (claim == no_claim) {
        const std::int64_t id = id_of(move, cell);
        const Offsets offsets = birth_offsets(id, particles.seed);
        particles.offset_x[cell] = offsets.x, particles.offset_y[cell] = offsets.y;
        particles.id[cell] = id;
        block.add(born, 1);
        return;
      }
      const std::int64_t from = claimant(claim);
      particles.offset_x[cell] = particles.moved_x[from], particles.offset_y[cell] = particles.moved_y[from];
      particles.id[cell] = particles.moved_id[from];
    });
  }
};

/// Places the particles under the surface (eq. 33) and hides those that are not in the sand.
struct ShowKernel {
  static constexpr const char* doing = "place particles";
  static constexpr int most_threads = threads_a_block;
  ParticleView particles;
  ParticleBox box;  // all
  SandView sand;
  double origin_x, origin_y;  // [m]
  double spacing;             // [m] of J
  float hide_below;           // [m]
  double* position;           // [m] x, y, z of each
  std::uint8_t* visible;

  template <class Block>
  SANDSIM_HD void operator()(Block& block) const {
    const int refinement = particles.grid.refinement;
    each_particle(block, box, [&](int column, int row, int layer) {
      const std::int64_t k = particles.cell(column, row, layer);
      const Place in_x{column, particles.offset_x[k]}, in_y{row, particles.offset_y[k]};
      const Place x = in_sand(in_x, refinement), y = in_sand(in_y, refinement);
      const Stencil sx = stencil(x), sy = stencil(y);
      const int i0 = image_of(sx.lower, sand.nx, sand.sides.x_min, sand.sides.x_max).index;
      const int i1 = image_of(sx.lower + 1, sand.nx, sand.sides.x_min, sand.sides.x_max).index;
      const int j0 = image_of(sy.lower, sand.ny, sand.sides.y_min, sand.sides.y_max).index;
      const int j1 = image_of(sy.lower + 1, sand.ny, sand.sides.y_min, sand.sides.y_max).index;
      const auto at = [&](const auto* values) {
        const auto* const below = values + static_cast<std::int64_t>(j0) * sand.nx;
        const auto* const above = values + static_cast<std::int64_t>(j1) * sand.nx;
        return interpolate(sx, sy, below[i0], below[i1], above[i0], above[i1]);
      };
      const double inside = static_cast<double>(birth_offsets(particles.id[k], particles.seed).z);
      const double below = spacing * (static_cast<double>(layer) + inside);
      position[3 * k] = origin_x + spacing * (in_x.cell + static_cast<double>(in_x.offset));
      position[3 * k + 1] = origin_y + spacing * (in_y.cell + static_cast<double>(in_y.offset));
      position[3 * k + 2] = at(sand.surface) - below;
      const float depth = sand.depth[static_cast<std::int64_t>(y.cell) * sand.nx + x.cell];
      visible[k] = depth >= hide_below && below <= static_cast<double>(at(sand.depth)) ? 1 : 0;
    });
  }
};

}  // namespace sandsim::particles
