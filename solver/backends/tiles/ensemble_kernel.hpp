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

/// Block k takes steps of run k until its loop halts. What all threads look at stays in shared memory meanwhile; the
/// states too, if they fit.
template <class Tile>
struct EnsembleKernel {
  using R = typename Tile::Real;
  static constexpr const char* doing = "take steps of many runs";
  static constexpr int most_threads = sizeof(R) == 4 ? 512 : 256;
  /// The run's numbers, in shared memory behind the rows of the tiles.
  struct alignas(16) Resident {
    Tile tile;
    Control<R> control;
  };

  const MemberView<Tile>* members;
  std::size_t rows_bytes;  // of the tiles, a multiple of 16
  bool states_fit;         // into shared memory, behind the numbers

  template <class Block>
  SANDSIM_HD void operator()(Block& block) const {
    const MemberView<Tile>& member = members[block.x()];
    if (member.control->go == 0) {
      return;
    }
    Resident& here = *reinterpret_cast<Resident*>(block.template shared<unsigned char>() + rows_bytes);
    move_in(block, member, here);
    const int nx = here.tile.fields.nx, ny = here.tile.fields.ny;
    const int height = (ny + block.strips() - 1) / block.strips();
    const auto bounds = [&](int strip) {
      return TileBounds{0, nx, physics::minimum(strip * height, ny), physics::minimum((strip + 1) * height, ny)};
    };
    while (here.control.go != 0) {
      typename Block::template PerThread<TileOutcome<R>> outcomes(block);
      const int current = here.control.current;
      here.tile.step(block, current, static_cast<R>(here.control.loop.step), height, bounds, outcomes);
      gather(block, outcomes, &here.control);
      double volume = 0.0;
      if (member.rain_count > 0) {
        volume = rain(block, here.tile, 1 - current, member.rains, member.rain_count, &here.control);
        block.each([&](int x, int strip) {
          if (x == 0 && strip == 0) {
            here.control.fastest_new = R(0);  // those of the step are no longer the state's
          }
        });
        raise_speeds(block, here.tile, 1 - current, 0, 1, &here.control.fastest_new);
      }
      close_step(block, here.tile, &here.control, volume);
      if (member.maxima.depth != nullptr) {
        block.each([&](int x, int strip) {
          take_cell_maxima(here.tile, here.control, member.maxima, strip * block.width() + x,
                           block.width() * block.strips());
        });
      }
    }
    move_out(block, member, here);
  }

 private:
  template <class Block>
  SANDSIM_HD void move_in(Block& block, const MemberView<Tile>& member, Resident& here) const {
    block.each([&](int x, int strip) {
      if (x == 0 && strip == 0) {
        here.tile = member.tile;
        here.control = *member.control;
        if (states_fit) {
          R* first = reinterpret_cast<R*>(&here + 1);
          const int nx = here.tile.fields.nx;
          const std::ptrdiff_t cells = static_cast<std::ptrdiff_t>(nx) * here.tile.fields.ny;
          here.tile.fields.states[0] = {first, first + cells, first + 2 * cells, nx};
          here.tile.fields.states[1] = {first + 3 * cells, first + 4 * cells, first + 5 * cells, nx};
        }
      }
    });
    if (states_fit) {
      const int current = here.control.current;
      copy_state(block, member.tile.fields.state(current), here.tile.fields.state(current), here.tile.fields);
    }
  }
  template <class Block>
  SANDSIM_HD void move_out(Block& block, const MemberView<Tile>& member, const Resident& here) const {
    if (states_fit) {
      const int current = here.control.current;
      copy_state(block, here.tile.fields.state(current), member.tile.fields.state(current), here.tile.fields);
    }
    block.each([&](int x, int strip) {
      if (x == 0 && strip == 0) {
        *member.control = here.control;
      }
    });
  }
  template <class Block>
  SANDSIM_HD static void copy_state(Block& block, const StateView<R>& from, const StateView<R>& to,
                                    const TileFields<R>& fields) {
    block.each([&](int x, int strip) {
      for (int j = strip; j < fields.ny; j += block.strips()) {
        for (int i = x; i < fields.nx; i += block.width()) {
          const std::ptrdiff_t a = from.at(i, j), b = to.at(i, j);
          to.h[b] = from.h[a], to.hu[b] = from.hu[a], to.hv[b] = from.hv[a];
        }
      }
    });
  }
};

}  // namespace sandsim::tiles
