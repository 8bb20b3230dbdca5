// Couples an object with the sand, by one block.
#pragma once

#include "solver/backends/coupling/couple.hpp"
#include "solver/backends/tiles/control.hpp"

namespace sandsim::tiles {

template <class Tile>
struct CoupleKernel {
  using R = typename Tile::Real;
  static constexpr const char* doing = "couple an object";
  static constexpr int most_threads = 256;
  coupling::Job<R> job;
  Coupling coupling;

  template <class Block>
  SANDSIM_HD void operator()(Block& block) const {
    coupling::couple(block, job, coupling);
  }
};

}  // namespace sandsim::tiles
