// Couples an object with the sand, by one block.
#pragma once

#include "solver/backends/coupling/couple.hpp"
#include "solver/backends/tiles/control.hpp"

namespace sandsim::tiles {

/// The largest speed of the cells that may have changed, and of their neighbours, goes to *fastest.
template <class Tile>
struct CoupleKernel {
  using R = typename Tile::Real;
  static constexpr const char* doing = "couple an object";
  static constexpr int most_threads = 256;
  Tile tile;
  coupling::Job<R> job;
  Coupling coupling;
  R* fastest;

  template <class Block>
  SANDSIM_HD void operator()(Block& block) const {
    coupling::couple(block, job, coupling);
    coupling::Patch wider = job.patch;
    wider.i0 -= 1, wider.i1 += 1;
    wider.j0 -= Tile::one_d ? 0 : 1, wider.j1 += Tile::one_d ? 0 : 1;
    block.each([&](int x, int strip) {
      R largest = 0;
      for (int cell = strip * block.width() + x; cell < wider.cells(); cell += block.width() * block.strips()) {
        const int i = wider.i0 + cell % wider.width(), j = wider.j0 + cell / wider.width();
        largest =
            physics::maximum(largest, tile.speed(job.state, tile.fields.column(i).index, tile.fields.row(j).index));
      }
      block.raise(fastest, largest);
    });
  }
};

}  // namespace sandsim::tiles
