// The paper's scheme on a tile: as balanced_tile.hpp, with a stencil of one cell and speeds that need no neighbours.
#pragma once

#include "solver/backends/tiles/tile_fields.hpp"
#include "solver/physics/paper_scheme.hpp"
#include "solver/physics/velocity.hpp"
#include "solver/physics/wave_speed.hpp"

namespace sandsim::tiles {

/// Chosen once a run. Flat: no bed is read. Uniform: no material maps. OneD: one row, no y axis.
template <class R, bool Flat, bool Uniform, bool OneD>
class PaperTile {
 public:
  using Real = R;
  static constexpr bool flat = Flat, uniform = Uniform, one_d = OneD;
  static constexpr int reach = 1;
  static constexpr int threads = 256;  // of a strip, at most
  static constexpr int shared_rows = 2 * (4 + 3);

  TileFields<R> fields;
  R courant = 0;
  physics::PaperSwitches<R> switches{};
  bool desingularised = false;  // velocities of eq. 13, else hu/h

  /// The Courant number is already in the speeds.
  SANDSIM_HD R stable_step(R fastest) const {
    return fastest > R(0) ? R(1) * fields.dx / fastest : physics::infinity<R>;
  }
  /// The speed that bounds the step in cell (i, j) of a state. [m/s]
  SANDSIM_HD R speed(const StateView<R>& state, int i, int j) const {
    const std::ptrdiff_t at = state.at(i, j);
    return speed_of({state.h[at], state.hu[at], state.hv[at]}, fields.parameters(R(0)));
  }

  /// Steps the tile of every strip, of up to `height` rows, from state `from` to the other one.
  template <class Block, class Bounds, class Outcomes>
  SANDSIM_HD void step(Block& block, int from, R dt, int height, const Bounds& bounds, Outcomes& outcomes) const;

 private:
  using Flux = physics::FaceFlux<R>;

  /// A cell of the present state.
  struct Cell {
    R h, hu, hv, u, v, b;
  };
  /// What a thread keeps of its column from row to row.
  struct Column {
    Image image;
    int stored;
    Cell ahead, high, middle, low;  // the rows r + 1, r, r - 1, r - 2
    Flux south, north, west;        // faces of `middle`
    R across_x;                     // difference of the surface over two cells
  };
  /// Rows of one strip in shared memory, two of each kind.
  struct SharedRows {
    R* base;
    int width;

    SANDSIM_HD R& at(int kind, int buffer, int x) const { return base[(2 * kind + buffer) * width + x]; }
  };

  SANDSIM_HD R velocity(R momentum, R h, const physics::StepParameters<R>& p) const {
    return desingularised ? physics::desingularised_velocity(momentum, h, p.inverse_dx)
                          : physics::quotient_velocity(momentum, h, p.dry_depth);
  }
  SANDSIM_HD R speed_of(const physics::State<R>& s, const physics::StepParameters<R>& p) const {
    return physics::paper_speed<OneD>(s.h, velocity(s.hu, s.h, p), velocity(s.hv, s.h, p), p.g, courant);
  }
  SANDSIM_HD Cell read(const StateView<R>& state, const Column& column, int j) const;
  SANDSIM_HD void put_cell(const SharedRows& shared, int x, int r, Column& c,
                           const physics::StepParameters<R>& p) const;
  /// The faces south and west of row j, which is `middle`, or of the row above the tile.
  SANDSIM_HD void find_faces(const SharedRows& shared, int x, int i, int j, const TileBounds& tile, Column& c,
                             const physics::StepParameters<R>& p) const;
  SANDSIM_HD physics::State<R> update(const SharedRows& shared, int x, int i, int j, const Column& c,
                                      const physics::StepParameters<R>& p) const;
};

template <class R, bool Flat, bool Uniform, bool OneD>
SANDSIM_HD auto PaperTile<R, Flat, Uniform, OneD>::read(const StateView<R>& state, const Column& column, int j) const
    -> Cell {
  const Image row = fields.row(j);
  const std::ptrdiff_t at = state.at(column.image.index, row.index);
  Cell cell{};
  cell.h = state.h[at];
  cell.hu = column.image.momentum(state.hu[at]);
  cell.hv = row.momentum(state.hv[at]);
  cell.b = Flat ? R(0) : fields.bed.row(fields.stored_row(j))[column.stored];
  return cell;
}

template <class R, bool Flat, bool Uniform, bool OneD>
SANDSIM_HD void PaperTile<R, Flat, Uniform, OneD>::put_cell(const SharedRows& shared, int x, int r, Column& c,
                                                            const physics::StepParameters<R>& p) const {
  c.high.u = velocity(c.high.hu, c.high.h, p);
  c.high.v = velocity(c.high.hv, c.high.h, p);
  const int buffer = r & 1;
  shared.at(0, buffer, x) = c.high.h, shared.at(1, buffer, x) = c.high.u, shared.at(2, buffer, x) = c.high.v;
  if constexpr (!Flat) {
    shared.at(3, buffer, x) = c.high.b;
  }
}

template <class R, bool Flat, bool Uniform, bool OneD>
SANDSIM_HD void PaperTile<R, Flat, Uniform, OneD>::find_faces(const SharedRows& shared, int x, int i, int j,
                                                              const TileBounds& tile, Column& c,
                                                              const physics::StepParameters<R>& p) const {
  const SideMass& out = fields.out;
  if constexpr (!OneD) {  // between `middle`, row j, and `high`
    c.north =
        physics::paper_flux<R>({c.middle.h, c.middle.v, c.middle.u}, {c.high.h, c.high.v, c.high.u}, switches, p.g);
    double* side = j == -1 ? out.y_min : (j == fields.ny - 1 ? out.y_max : nullptr);
    if (side != nullptr) {
      const double mass = pass_outwards(c.north, j != -1);
      if (tile.holds(i, j == -1 ? 0 : j)) {
        side[i] = mass;
      }
    }
  }
  const int buffer = j & 1, w = x > 0 ? x - 1 : x, e = x + 1 < shared.width ? x + 1 : x;
  c.west = physics::paper_flux<R>({shared.at(0, buffer, w), shared.at(1, buffer, w), shared.at(2, buffer, w)},
                                  {c.middle.h, c.middle.u, c.middle.v}, switches, p.g);
  double* side = i == 0 ? out.x_min : (i == fields.nx ? out.x_max : nullptr);
  if (side != nullptr) {
    const double mass = pass_outwards(c.west, i != 0);
    if (tile.holds(i == 0 ? i : i - 1, j)) {
      side[j] = mass;
    }
  }
  c.across_x = shared.at(0, buffer, e) - shared.at(0, buffer, w);
  if constexpr (!Flat) {
    c.across_x = c.across_x + (shared.at(3, buffer, e) - shared.at(3, buffer, w));
  }
  shared.at(4, buffer, x) = c.west.mass, shared.at(5, buffer, x) = c.west.normal;
  shared.at(6, buffer, x) = c.west.transverse;
}

template <class R, bool Flat, bool Uniform, bool OneD>
SANDSIM_HD physics::State<R> PaperTile<R, Flat, Uniform, OneD>::update(const SharedRows& shared, int x, int i, int j,
                                                                       const Column& c,
                                                                       const physics::StepParameters<R>& p) const {
  const Flux east{shared.at(4, j & 1, x + 1), shared.at(5, j & 1, x + 1), shared.at(6, j & 1, x + 1), R(0), R(0)};
  R across_y = OneD ? R(0) : c.high.h - c.low.h;
  if constexpr (!Flat && !OneD) {
    across_y = across_y + (c.high.b - c.low.b);
  }
  return physics::paper_update<OneD>(c.middle.h, c.middle.u, c.middle.v, c.across_x, across_y, c.west, east, c.south,
                                     c.north, fields.template material_at<Uniform>(i, j), p);
}

template <class R, bool Flat, bool Uniform, bool OneD>
template <class Block, class Bounds, class Outcomes>
SANDSIM_HD void PaperTile<R, Flat, Uniform, OneD>::step(Block& block, int from, R dt, int height, const Bounds& bounds,
                                                        Outcomes& outcomes) const {
  const StateView<R>&present = fields.state(from), &next = fields.state(1 - from);
  const physics::StepParameters<R> p = fields.parameters(dt);
  const int width = block.width();
  typename Block::template PerThread<Column> columns(block);
  const auto rows_of = [&](int strip) {
    return SharedRows{block.template shared<R>() + strip * shared_rows * width, width};
  };
  const auto column_of = [&](const TileBounds& tile, int x) { return tile.i0 - reach + x; };
  const auto first_row = [&](const TileBounds& tile) { return OneD ? tile.j0 : tile.j0 - reach; };

  block.each([&](int x, int strip) {
    const TileBounds tile = bounds(strip);
    Column& c = columns(x, strip);
    const int i = column_of(tile, x);
    c.image = fields.column(i);
    c.stored = fields.stored_column(i);
    c.ahead = read(present, c, first_row(tile));
  });
  const int rows = OneD ? 2 : height + 2 * reach;
  for (int n = 0; n < rows; ++n) {
    block.each([&](int x, int strip) {
      const TileBounds tile = bounds(strip);
      const SharedRows shared = rows_of(strip);
      Column& c = columns(x, strip);
      const int r = first_row(tile) + n;
      c.low = c.middle, c.middle = c.high, c.high = c.ahead, c.south = c.north;
      if (!OneD || n == 0) {
        put_cell(shared, x, r, c, p);
        if (!OneD && n + 1 < rows) {
          c.ahead = read(present, c, r + 1);
        }
      }
      if (n >= 1) {
        find_faces(shared, x, column_of(tile, x), r - 1, tile, c, p);
      }
    });
    if (n < (OneD ? 1 : 2)) {
      continue;
    }
    block.each([&](int x, int strip) {
      const TileBounds tile = bounds(strip);
      Column& c = columns(x, strip);
      TileOutcome<R>& outcome = outcomes(x, strip);
      const int i = column_of(tile, x), j = first_row(tile) + n - 1;
      if (tile.holds(i, j)) {
        const physics::State<R> made = update(rows_of(strip), x, i, j, c, p);
        outcome.bits |= step_bits(c.middle.h, c.middle.hu, c.middle.hv, made.h, made.hu, made.hv);
        outcome.fastest = physics::maximum(outcome.fastest, speed_of(made, p));
        const std::ptrdiff_t at = next.at(i, j);
        next.h[at] = made.h, next.hu[at] = made.hu, next.hv[at] = made.hv;
      }
    });
  }
}

}  // namespace sandsim::tiles
