// The launches of a run on tiles. A kernel is a trivially copyable object that is called with a
// block; `doing` is for messages.
#pragma once

#include "solver/backends/particles/sand_view.hpp"
#include "solver/backends/tiles/block_functions.hpp"

namespace sandsim::tiles {

/// Threads of a block that goes over cells one by one.
inline constexpr int cell_threads = 256;

/// Steps every tile of the grid. The block that comes last ends the step, unless rain follows.
template <class Tile>
struct StepKernel {
  static constexpr const char* doing = "take a step";
  static constexpr int most_threads = Tile::threads;
  using R = typename Tile::Real;
  Tile tile;
  TileLayout layout;
  Control<R>* control;
  bool rain_follows;

  template <class Block>
  SANDSIM_HD void operator()(Block& block) const {
    if (block.read(&control->go) == 0) {
      return;
    }
    typename Block::template PerThread<TileOutcome<R>> outcomes(block);
    const auto bounds = [&](int strip) { return layout.bounds(block, strip, tile.fields.nx, tile.fields.ny); };
    const int current = control->current;
    tile.step(block, current, static_cast<R>(control->loop.step), layout.height, bounds, outcomes);
    gather(block, outcomes, control);
    if (!rain_follows && block.last(&control->arrived)) {
      close_step(block, tile, control, 0.0);
    }
  }
};

/// Rain, by one block: onto the state that the step has made, or between steps onto the present one.
template <class Tile>
struct RainKernel {
  static constexpr const char* doing = "add sand";
  static constexpr int most_threads = sum_lanes;
  using R = typename Tile::Real;
  Tile tile;
  Control<R>* control;
  const RainView* rains;
  int count;
  bool onto_new;

  template <class Block>
  SANDSIM_HD void operator()(Block& block) const {
    if (block.read(&control->go) == 0) {
      return;
    }
    const int current = control->current;
    const double volume = rain(block, tile, onto_new ? 1 - current : current, rains, count, control);
    block.each([&](int x, int strip) {
      if (x == 0 && strip == 0) {
        control->rained = volume;
        control->fastest_new = R(0);  // those of the step are no longer the state's
      }
    });
  }
};

/// Ends a step in which it has rained: the next one is bounded by the speeds of the state as it is then.
template <class Tile>
struct EndRainKernel {
  static constexpr const char* doing = "end a step with new sand";
  static constexpr int most_threads = cell_threads;
  using R = typename Tile::Real;
  Tile tile;
  Control<R>* control;

  template <class Block>
  SANDSIM_HD void operator()(Block& block) const {
    if (block.read(&control->go) == 0) {
      return;
    }
    raise_speeds(block, tile, 1 - control->current, block.x(), block.blocks(), &control->fastest_new);
    if (block.last(&control->arrived)) {
      close_step(block, tile, control, control->rained);
    }
  }
};

/// cell(k) for the cells k = j nx + i of the grid, shared out among the threads of all blocks, by the thread at x of
/// this block.
template <class Block, class R, class Cell>
SANDSIM_HD void each_cell_of(const Block& block, const TileFields<R>& fields, int x, const Cell& cell) {
  const std::int64_t cells = static_cast<std::int64_t>(fields.nx) * fields.ny;
  const std::int64_t stride = static_cast<std::int64_t>(block.width()) * block.blocks();
  for (std::int64_t k = static_cast<std::int64_t>(block.x()) * block.width() + x; k < cells; k += stride) {
    cell(k);
  }
}

/// Takes the present state into the maxima.
template <class Tile>
struct MaximaKernel {
  static constexpr const char* doing = "take maxima";
  static constexpr int most_threads = cell_threads;
  using R = typename Tile::Real;
  Tile tile;
  const Control<R>* control;
  MaximaView<R> maxima;

  template <class Block>
  SANDSIM_HD void operator()(Block& block) const {
    block.each([&](int x, int) {
      const std::int64_t thread = static_cast<std::int64_t>(block.x()) * block.width() + x;
      take_cell_maxima(tile, *control, maxima, thread, static_cast<std::int64_t>(block.width()) * block.blocks());
    });
  }
};

/// The largest speed of the present state goes to *fastest, which is 0 before.
template <class Tile>
struct SpeedKernel {
  static constexpr const char* doing = "find the largest speed";
  static constexpr int most_threads = cell_threads;
  using R = typename Tile::Real;
  Tile tile;
  int current;
  R* fastest;

  template <class Block>
  SANDSIM_HD void operator()(Block& block) const {
    raise_speeds(block, tile, current, block.x(), block.blocks(), fastest);
  }
};

/// The first cell whose speed is *fastest goes to *cell, which is the number of cells before.
template <class Tile>
struct FindSpeedKernel {
  static constexpr const char* doing = "find the fastest cell";
  static constexpr int most_threads = cell_threads;
  using R = typename Tile::Real;
  Tile tile;
  int current;
  const R* fastest;
  std::int64_t* cell;

  template <class Block>
  SANDSIM_HD void operator()(Block& block) const {
    block.each([&](int x, int) {
      each_cell_of(block, tile.fields, x, [&](std::int64_t k) {
        if (speed_of_cell(tile, current, k) == *fastest) {
          block.lower(cell, k);
        }
      });
    });
  }
};

/// visit(k, i, j, h, hu, hv, b) of every cell of a state, k-th in rows of nx, with the bed that the flow sees.
template <class Block, class Tile, class Visit>
SANDSIM_HD void each_cell_state(Block& block, const Tile& tile, int current, const Visit& visit) {
  using R = typename Tile::Real;
  block.each([&](int x, int) {
    const auto& f = tile.fields;
    const StateView<R>& state = f.state(current);
    each_cell_of(block, f, x, [&](std::int64_t k) {
      const int i = static_cast<int>(k % f.nx), j = static_cast<int>(k / f.nx);
      const std::ptrdiff_t at = state.at(i, j);
      visit(k, i, j, state.h[at], state.hu[at], state.hv[at], Tile::flat ? R(0) : f.bed.row(j)[i]);
    });
  });
}

/// A field of the present state, rows of nx.
template <class Tile>
struct FieldKernel {
  static constexpr const char* doing = "copy a field";
  static constexpr int most_threads = cell_threads;
  using R = typename Tile::Real;
  Tile tile;
  int current;
  CellField field;
  R* values;

  template <class Block>
  SANDSIM_HD void operator()(Block& block) const {
    each_cell_state(block, tile, current, [&](std::int64_t k, int i, int j, R h, R hu, R hv, R b) {
      values[k] = cell_value(field, tile.fields.cover, i, j, h, hu, hv, b, tile.fields.dry_depth);
    });
  }
};

/// The present state as the particles see it.
template <class Tile>
struct ParticleSandKernel {
  static constexpr const char* doing = "show the sand to the particles";
  static constexpr int most_threads = cell_threads;
  using R = typename Tile::Real;
  Tile tile;
  int current;
  particles::SandView sand;

  template <class Block>
  SANDSIM_HD void operator()(Block& block) const {
    each_cell_state(block, tile, current, [&](std::int64_t, int i, int j, R h, R hu, R hv, R b) {
      const auto& f = tile.fields;
      sand.take(i, j, h, hu, hv, b, f.cover, f.template material_at<Tile::uniform>(i, j), f.dry_depth);
    });
  }
};

/// Depth and velocity of single cells, three numbers each.
template <class Tile>
struct ProbeKernel {
  static constexpr const char* doing = "read probes";
  static constexpr int most_threads = cell_threads;
  using R = typename Tile::Real;
  Tile tile;
  int current;
  const std::int64_t* cells;
  std::int64_t count;
  double* values;

  template <class Block>
  SANDSIM_HD void operator()(Block& block) const {
    block.each([&](int x, int) {
      const std::int64_t k = static_cast<std::int64_t>(block.x()) * block.width() + x;
      if (k < count) {
        const StateView<R>& state = tile.fields.state(current);
        const int i = static_cast<int>(cells[k] % tile.fields.nx), j = static_cast<int>(cells[k] / tile.fields.nx);
        const std::ptrdiff_t at = state.at(i, j);
        const R h = state.h[at], dry = tile.fields.dry_depth;
        values[3 * k] = static_cast<double>(tile.fields.cover.depth(i, j, h));
        values[3 * k + 1] = static_cast<double>(physics::quotient_velocity(state.hu[at], h, dry));
        values[3 * k + 2] = static_cast<double>(physics::quotient_velocity(state.hv[at], h, dry));
      }
    });
  }
};

/// Sums of row block.x(), by one block of 32 threads.
template <class Tile>
struct RowSumsKernel {
  static constexpr const char* doing = "sum rows";
  static constexpr int most_threads = sum_lanes;
  using R = typename Tile::Real;
  Tile tile;
  int current;
  R above;  // [m] see BackendConfig
  CellSums* rows;

  template <class Block>
  SANDSIM_HD void operator()(Block& block) const {
    const StateView<R>& state = tile.fields.state(current);
    const int j = block.x();
    const CellSums sums = block_sum<CellSums>(block, tile.fields.nx, [&](CellSums& lane, std::int64_t i) {
      const int column = static_cast<int>(i);
      const std::ptrdiff_t at = state.at(column, j);
      lane.add_cell(state.h[at], state.hu[at], state.hv[at], tile.fields.cover.buried_at(column, j), above);
    });
    block.each([&](int x, int) {
      if (x == 0) {
        rows[j] = sums;
      }
    });
  }
};

/// Sum over the rows, by one block of 32 threads.
struct TotalKernel {
  static constexpr const char* doing = "sum up";
  static constexpr int most_threads = sum_lanes;
  const CellSums* rows;
  int count;
  CellSums* total;

  template <class Block>
  SANDSIM_HD void operator()(Block& block) const {
    const CellSums sums = block_sum<CellSums>(block, count, [&](CellSums& lane, std::int64_t j) { lane += rows[j]; });
    block.each([&](int x, int) {
      if (x == 0) {
        *total = sums;
      }
    });
  }
};

}  // namespace sandsim::tiles
