// A loop of steps of one run in each block.
#pragma once

#include "solver/backends/tiles/block_functions.hpp"

namespace sandsim::tiles {

/// A run as its block finds it.
template <class Tile>
struct MemberView {
  using R = typename Tile::Real;
  Tile tile;
  Control<R>* control;
  const RainView* rains;
  int rain_count;
  MaximaView<R> maxima;  // null without
};

/// Block k takes steps of run k until its loop halts. The state stays in shared memory meanwhile, if it fits.
template <class Tile>
struct EnsembleKernel {
  using R = typename Tile::Real;
  static constexpr const char* doing = "take steps of many runs";
  static constexpr int most_threads = sizeof(R) == 4 ? 512 : 256;
  const MemberView<Tile>* members;
  std::size_t state_offset;  // [B] in shared memory, behind the rows of the tiles
  bool resident;             // the states are in shared memory

  template <class Block>
  SANDSIM_HD void operator()(Block& block) const {
    const MemberView<Tile>& member = members[block.x()];
    Tile tile = member.tile;
    Control<R>* control = member.control;
    if (block.read(&control->go) == 0) {
      return;
    }
    if (resident) {
      move_in(block, tile, control);
    }
    const int nx = tile.fields.nx, ny = tile.fields.ny;
    const int height = (ny + block.strips() - 1) / block.strips();
    const auto bounds = [&](int strip) {
      return TileBounds{0, nx, physics::minimum(strip * height, ny), physics::minimum((strip + 1) * height, ny)};
    };
    while (block.read(&control->go) != 0) {
      typename Block::template PerThread<TileOutcome<R>> outcomes(block);
      const int current = control->current;
      tile.step(block, current, static_cast<R>(control->loop.step), height, bounds, outcomes);
      gather(block, outcomes, control);
      const double volume = rain(block, tile, 1 - current, member.rains, member.rain_count, control);
      close_step(block, tile, control, volume);
      if (member.maxima.depth != nullptr) {
        block.each([&](int x, int strip) {
          take_cell_maxima(tile, *control, member.maxima, strip * block.width() + x, block.width() * block.strips());
        });
      }
    }
    if (resident) {
      move_out(block, tile, member.tile, control->current);
    }
  }

 private:
  /// Copies the present state into shared memory and points the tile there.
  template <class Block>
  SANDSIM_HD void move_in(Block& block, Tile& tile, const Control<R>* control) const {
    const StateView<R> from = tile.fields.state(control->current);
    const int nx = tile.fields.nx, ny = tile.fields.ny;
    R* first = reinterpret_cast<R*>(block.template shared<unsigned char>() + state_offset);
    const std::ptrdiff_t cells = static_cast<std::ptrdiff_t>(nx) * ny;
    tile.fields.states[0] = {first, first + cells, first + 2 * cells, nx};
    tile.fields.states[1] = {first + 3 * cells, first + 4 * cells, first + 5 * cells, nx};
    copy_state(block, from, tile.fields.state(control->current), nx, ny);
  }
  template <class Block>
  SANDSIM_HD void move_out(Block& block, const Tile& tile, const Tile& home, int current) const {
    copy_state(block, tile.fields.state(current), home.fields.state(current), tile.fields.nx, tile.fields.ny);
  }
  template <class Block>
  SANDSIM_HD static void copy_state(Block& block, const StateView<R>& from, const StateView<R>& to, int nx, int ny) {
    block.each([&](int x, int strip) {
      for (int j = strip; j < ny; j += block.strips()) {
        for (int i = x; i < nx; i += block.width()) {
          const std::ptrdiff_t a = from.at(i, j), b = to.at(i, j);
          to.h[b] = from.h[a], to.hu[b] = from.hu[a], to.hv[b] = from.hv[a];
        }
      }
    });
  }
};

}  // namespace sandsim::tiles
