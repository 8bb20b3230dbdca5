// The numbers that steer a loop of steps where the state is: the host sets them before and reads them after.
#pragma once

#include <cstdint>

#include "solver/backends/sums.hpp"
#include "solver/backends/tiles/tile_fields.hpp"
#include "solver/stepping.hpp"

namespace sandsim::tiles {

template <class R>
struct Control {
  StepLoop loop;
  StepRules rules;
  StepOutcome outcome;         // of the last step
  std::int64_t remaining = 0;  // steps that may still be taken before the host looks
  int go = 0;                  // whether the planned step is to be taken
  int current = 0;             // state that is the present one
  R fastest = 0;               // [m/s] bounds the planned step
  // Gathered from all blocks during a step:
  R fastest_new = 0;  // [m/s]
  int bits = 0;
  double rained = 0.0;   // [m^3] onto the state that the step has made
  unsigned arrived = 0;  // blocks
};

/// What a source's cells are on the machine.
struct RainView {
  const std::int64_t* cells = nullptr;  // j * nx + i
  std::int64_t count = 0;
  double rate = 0.0;              // [m/s]
  double start = 0.0, end = 0.0;  // [s]
};

/// max_depth, max_speed and arrival_time of every cell, rows of nx.
template <class R>
struct MaximaView {
  R *depth = nullptr, *speed = nullptr, *arrival = nullptr;
  R above = 0;    // [m] see BackendConfig
  R drained = 0;  // [-] likewise
};

/// How the tiles of a block lie in the grid: strips of one width and height, one above the other.
struct TileLayout {
  int columns = 1;
  int height = 1;

  template <class Block>
  SANDSIM_HD TileBounds bounds(const Block& block, int strip, int nx, int ny) const {
    const int i0 = block.x() * columns, j0 = (block.y() * block.strips() + strip) * height;
    return {i0, physics::minimum(i0 + columns, nx), j0, physics::minimum(j0 + height, ny)};
  }
};

}  // namespace sandsim::tiles
