// What a block of threads does in a step besides the tiles themselves: sums, rain, the end of a step. Each function is
// called between phases and waits for all threads before it returns.
#pragma once

#include <algorithm>

#include "solver/backends/cell_values.hpp"
#include "solver/backends/tiles/block.hpp"
#include "solver/backends/tiles/control.hpp"

namespace sandsim::tiles {

/// Shared memory that block_sum() needs. [B]
inline constexpr std::size_t block_sum_bytes = sum_lanes * 64;

/// Shared memory for a step with tiles. [B]
template <class Tile>
std::size_t step_shared_bytes(const BlockShape& shape) {
  using R = typename Tile::Real;
  const auto threads = static_cast<std::size_t>(shape.threads());
  const std::size_t rows = threads * Tile::shared_rows * sizeof(R), gathered = threads * (sizeof(R) + sizeof(int));
  return std::max({rows, gathered, block_sum_bytes});
}

/// Adds up add(lane, k) over k = 0 .. n - 1 as sum_in_lanes() does. Needs 32 shared values, and a block at least 32
/// threads wide, of which the first 32 work; the result is the same for every thread.
template <class T, class Block, class Add>
SANDSIM_HD T block_sum(Block& block, std::int64_t n, Add add) {
  static_assert(sizeof(T) * sum_lanes <= block_sum_bytes);
  T* lanes = block.template shared<T>();
  block.each([&](int x, int strip) {
    if (strip == 0 && x < sum_lanes) {
      T lane{};
      for (std::int64_t k = x; k < n; k += sum_lanes) {
        add(lane, k);
      }
      lanes[x] = lane;
    }
  });
  for (int half = sum_lanes / 2; half > 0; half /= 2) {
    block.each([&](int x, int strip) {
      if (strip == 0 && x < half) {
        lanes[x] += lanes[x + half];
      }
    });
  }
  const T sum = lanes[0];
  block.each([](int, int) {});  // before the lanes are used again
  return sum;
}

/// Brings the outcomes of all threads together and into `control`. Needs two shared numbers a thread.
template <class R, class Block, class Outcomes>
SANDSIM_HD void gather(Block& block, Outcomes& outcomes, Control<R>* control) {
  const int threads = block.width() * block.strips();
  R* fastest = block.template shared<R>();
  int* bits = reinterpret_cast<int*>(fastest + threads);
  block.each([&](int x, int strip) {
    const int t = strip * block.width() + x;
    fastest[t] = outcomes(x, strip).fastest, bits[t] = outcomes(x, strip).bits;
  });
  for (int n = threads; n > 1; n = (n + 1) / 2) {
    block.each([&](int x, int strip) {
      const int t = strip * block.width() + x, other = t + (n + 1) / 2;
      if (other < n) {
        fastest[t] = physics::maximum(fastest[t], fastest[other]);
        bits[t] |= bits[other];
      }
    });
  }
  block.each([&](int x, int strip) {
    if (x == 0 && strip == 0) {
      block.raise(&control->fastest_new, fastest[0]);
      block.set_bits(&control->bits, bits[0]);
    }
  });
}

/// Volume that left through open sides. [m^3]
template <class Tile, class Block>
SANDSIM_HD double outflow(Block& block, const Tile& tile, double dt) {
  using R = typename Tile::Real;
  const auto& f = tile.fields;
  double mass = 0.0;
  const auto add_side = [&](const double* side, int faces) {
    if (side != nullptr) {
      mass += block_sum<double>(block, faces, [&](double& lane, std::int64_t k) { lane += block.read(side + k); });
    }
  };
  add_side(f.out.x_min, f.ny), add_side(f.out.x_max, f.ny);
  add_side(f.out.y_min, f.nx), add_side(f.out.y_max, f.nx);
  return mass * static_cast<double>(static_cast<R>(dt)) * tile.fields.spacing;
}

/// Rain during the planned step onto the state `which`. The speeds of that state are no longer known after it. [m^3]
template <class Tile, class Block>
SANDSIM_HD double rain(Block& block, const Tile& tile, int which, const RainView* rains, int count,
                       const Control<typename Tile::Real>* control) {
  using R = typename Tile::Real;
  const StateView<R>& state = tile.fields.state(which);
  const double begin = control->loop.time, end = control->loop.time + control->loop.step;
  const int nx = tile.fields.nx;
  double volume = 0.0;
  for (int k = 0; k < count; ++k) {
    const RainView source = rains[k];
    const double open = physics::minimum(end, source.end) - physics::maximum(begin, source.start);
    if (!(open > 0.0)) {
      continue;
    }
    const R growth = static_cast<R>(source.rate * open);
    const double gained = block_sum<double>(block, source.count, [&](double& lane, std::int64_t n) {
      const std::int64_t cell = source.cells[n];
      R& h = state.h[state.at(static_cast<int>(cell % nx), static_cast<int>(cell / nx))];
      const R before = h;
      h = h + growth;
      lane += static_cast<double>(h) - static_cast<double>(before);
    });
    volume += gained * tile.fields.spacing * tile.fields.spacing;
  }
  return volume;
}

/// The speed that bounds the step in cell k of the state `which`.
template <class Tile>
SANDSIM_HD typename Tile::Real speed_of_cell(const Tile& tile, int which, std::int64_t k) {
  const int nx = tile.fields.nx;
  return tile.speed(tile.fields.state(which), static_cast<int>(k % nx), static_cast<int>(k / nx));
}

/// Raises *fastest to the largest speed of the state `which`; the block is number `number` of `blocks` that share the
/// cells.
template <class Tile, class Block>
SANDSIM_HD void raise_speeds(Block& block, const Tile& tile, int which, int number, int blocks,
                             typename Tile::Real* fastest) {
  using R = typename Tile::Real;
  const std::int64_t cells = static_cast<std::int64_t>(tile.fields.nx) * tile.fields.ny;
  const int threads = block.width() * block.strips();
  block.each([&](int x, int strip) {
    R largest = 0;
    for (std::int64_t k = static_cast<std::int64_t>(number) * threads + strip * block.width() + x; k < cells;
         k += static_cast<std::int64_t>(threads) * blocks) {
      largest = physics::maximum(largest, speed_of_cell(tile, which, k));
    }
    block.raise(fastest, largest);
  });
}

/// After the last change to the new state: makes it the present one and plans the next step.
template <class Tile, class Block>
SANDSIM_HD void close_step(Block& block, const Tile& tile, Control<typename Tile::Real>* control, double volume_in) {
  using R = typename Tile::Real;
  const double volume_out = outflow(block, tile, control->loop.step);
  block.each([&](int x, int strip) {
    if (x != 0 || strip != 0) {
      return;
    }
    Control<R>& c = *control;
    const int bits = block.read(&c.bits);
    c.outcome = {(bits & bit_moving) != 0, (bits & bit_changed) != 0, (bits & bit_broken) != 0, volume_out};
    c.fastest = block.read(&c.fastest_new);
    c.fastest_new = R(0), c.bits = 0;
    c.current = 1 - c.current;
    c.remaining -= 1;
    c.loop.volume_in += volume_in;
    c.loop.finish(c.rules, c.outcome);
    if (c.loop.halt == Halt::none) {
      c.loop.plan(c.rules, static_cast<double>(tile.stable_step(c.fastest)));
    }
    c.go = c.loop.halt == Halt::none && c.remaining > 0 ? 1 : 0;
    block.repeat(c.go != 0);
  });
}

/// Takes the present state into the maxima of cells first, first + stride, ...
template <class Tile>
SANDSIM_HD void take_cell_maxima(const Tile& tile, const Control<typename Tile::Real>& control,
                                 const MaximaView<typename Tile::Real>& maxima, std::int64_t first,
                                 std::int64_t stride) {
  using R = typename Tile::Real;
  const auto& f = tile.fields;
  const StateView<R>& state = f.state(control.current);
  const std::int64_t cells = static_cast<std::int64_t>(f.nx) * f.ny;
  for (std::int64_t k = first; k < cells; k += stride) {
    const int i = static_cast<int>(k % f.nx), j = static_cast<int>(k / f.nx);
    const std::ptrdiff_t at = state.at(i, j);
    take_maxima(f.cover.depth(i, j, state.h[at]), state.h[at], state.hu[at], state.hv[at],
                static_cast<R>(control.loop.time), maxima.above, maxima.drained, f.dry_depth, maxima.depth[k],
                maxima.speed[k], maxima.arrival[k]);
  }
}

}  // namespace sandsim::tiles
