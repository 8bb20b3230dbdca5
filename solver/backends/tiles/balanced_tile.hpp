// The balanced scheme on a tile. A strip of threads, one a column, walks over the rows of its tile from low to high y.
// Each row costs every thread one reconstruction, one face to the west, one to the south and one update; columns
// exchange what their neighbours need in shared rows, two of each kind so that one wait a row is enough. Three cells
// around the tile are read and two computed again, so that the speeds of the new state are known where it is written.
#pragma once

#include "solver/backends/tiles/tile_fields.hpp"
#include "solver/physics/balanced_update.hpp"
#include "solver/physics/velocity.hpp"
#include "solver/physics/wave_speed.hpp"

namespace sandsim::tiles {

/// Chosen once a run. Flat: no bed is read. Uniform: no material maps. OneD: one row, no y axis.
template <class R, int Order, bool Flat, bool Uniform, bool OneD>
class BalancedTile {
 public:
  using Real = R;
  static constexpr bool flat = Flat, uniform = Uniform, one_d = OneD;
  /// Columns at either end of a strip of threads that only read or compute again.
  static constexpr int reach = 3;
  static constexpr int threads = sizeof(R) == 4 ? 128 : 64;  // of a strip, at most
  /// Shared rows of numbers a strip needs.
  static constexpr int shared_rows = 2 * (4 + 9 + 4 + 1);

  TileFields<R> fields;
  R courant = 0;

  SANDSIM_HD R stable_step(R fastest) const {
    return fastest > R(0) ? courant * fields.dx / fastest : physics::infinity<R>;
  }
  /// The speed that bounds the step in cell (i, j) of a state. [m/s]
  SANDSIM_HD R speed(const StateView<R>& state, int i, int j) const;

  /// Steps the tile of every strip, of up to `height` rows, from state `from` to the other one.
  template <class Block, class Bounds, class Outcomes>
  SANDSIM_HD void step(Block& block, int from, R dt, int height, const Bounds& bounds, Outcomes& outcomes) const;

 private:
  using Flux = physics::FaceFlux<R>;
  using Side = physics::FaceSide<R>;
  using Reconstruction = physics::CellReconstruction<R>;

  /// A cell of the present state.
  struct Cell {
    R h, hu, hv, u, v, b;
    physics::Material<R> material;
  };
  /// What a thread keeps of its column from row to row.
  struct Column {
    Image image;
    int stored;
    Cell ahead, high, middle, low;  // the rows r + 1, r, r - 1, r - 2
    Reconstruction of_middle, of_low;
    Flux south, north, west;           // faces of `low`
    physics::State<R> made, made_low;  // new cells of the rows r - 3, r - 4
  };

  struct SharedRows;
  /// Which stages act when row r = first_row + n is read: the faces are those of row r - 2, which is updated; speeds
  /// are those of row r - 3. A single row goes through the stages one after the other.
  struct Schedule {
    bool reads, reconstructs, finds_faces, updates, finds_speeds;

    SANDSIM_HD explicit Schedule(int n)
        : reads(!OneD || n == 0),
          reconstructs(OneD ? n == 1 : n >= 2),
          finds_faces(OneD ? n == 2 : n >= 3),
          updates(OneD ? n == 2 : n >= 4),
          finds_speeds(OneD ? n == 3 : n >= 6) {}
    SANDSIM_HD static int rows(int height) { return OneD ? 4 : height + 2 * reach; }
  };
  SANDSIM_HD static int first_row(const TileBounds& tile) { return OneD ? tile.j0 : tile.j0 - reach; }

  SANDSIM_HD Cell read(const StateView<R>& state, const Column& column, int j) const;
  SANDSIM_HD void find_velocity(Cell& cell) const;
  SANDSIM_HD static Side side_x(const Cell& cell, const Reconstruction& r, R half);
  SANDSIM_HD static Side side_y(const Cell& cell, const Reconstruction& r, R half);
  SANDSIM_HD Reconstruction reconstruct(const SharedRows& shared, int buffer, int x, int width, const Column& c,
                                        const physics::StepParameters<R>& p) const;
  /// The faces south and west of `low`, which is row j - 1.
  SANDSIM_HD void find_faces(const SharedRows& shared, int x, int i, int j, const TileBounds& tile, Column& c,
                             const physics::StepParameters<R>& p) const;
  SANDSIM_HD physics::State<R> update(const Column& c, const Flux& east, const physics::StepParameters<R>& p) const;
  SANDSIM_HD R line_speed(const physics::Line<R>& x, const physics::Line<R>& y, R u, R v, const physics::Material<R>& m,
                          const physics::StepParameters<R>& p) const;
  SANDSIM_HD R new_speed(const SharedRows& shared, int x, int i, int j, const Column& c, R h_north,
                         const physics::StepParameters<R>& p) const;
  SANDSIM_HD void read_bed(physics::Line<R>& x, physics::Line<R>& y, int i, int j) const;
};

/// Rows of one strip in shared memory, two of each kind.
template <class R, int Order, bool Flat, bool Uniform, bool OneD>
struct BalancedTile<R, Order, Flat, Uniform, OneD>::SharedRows {
  R* base;
  int width;

  SANDSIM_HD R& at(int kind, int buffer, int x) const { return base[(2 * kind + buffer) * width + x]; }

  SANDSIM_HD void put_cell(int buffer, int x, const Cell& cell) const {
    at(0, buffer, x) = cell.h, at(1, buffer, x) = cell.u, at(2, buffer, x) = cell.v;
    if constexpr (!Flat) {
      at(3, buffer, x) = cell.b;
    }
  }
  /// A cell as the face to its east sees it. The material is not shared: it is read again where there are maps.
  SANDSIM_HD void put_side(int buffer, int x, const Side& side) const {
    at(4, buffer, x) = side.h, at(5, buffer, x) = side.normal, at(6, buffer, x) = side.transverse;
    at(7, buffer, x) = side.demand, at(8, buffer, x) = side.K;
    if constexpr (!Flat) {
      at(9, buffer, x) = side.b, at(10, buffer, x) = side.ss;
    }
    if constexpr (Order == 2) {
      at(11, buffer, x) = side.sh, at(12, buffer, x) = side.dh;
    }
  }
  SANDSIM_HD Side side(int buffer, int x, const physics::Material<R>& material) const {
    Side side{at(4, buffer, x), R(0),    at(5, buffer, x), at(6, buffer, x), R(0), R(0), R(0), at(7, buffer, x),
              at(8, buffer, x), material};
    if constexpr (Order == 2) {
      side.sh = side.ss = at(11, buffer, x), side.dh = at(12, buffer, x);
    }
    if constexpr (!Flat) {
      side.b = at(9, buffer, x), side.ss = at(10, buffer, x);
    }
    return side;
  }
  /// A face as the cell to its west sees it.
  SANDSIM_HD void put_flux(int buffer, int x, const Flux& flux) const {
    at(13, buffer, x) = flux.mass, at(14, buffer, x) = flux.normal, at(15, buffer, x) = flux.transverse;
    at(16, buffer, x) = flux.jump_left;
  }
  SANDSIM_HD Flux flux(int buffer, int x) const {
    return {at(13, buffer, x), at(14, buffer, x), at(15, buffer, x), at(16, buffer, x), R(0)};
  }
  SANDSIM_HD R& new_depth(int buffer, int x) const { return at(17, buffer, x); }
};

template <class R, int Order, bool Flat, bool Uniform, bool OneD>
SANDSIM_HD auto BalancedTile<R, Order, Flat, Uniform, OneD>::read(const StateView<R>& state, const Column& column,
                                                                  int j) const -> Cell {
  const Image row = fields.row(j);
  const std::ptrdiff_t at = state.at(column.image.index, row.index);
  Cell cell;
  cell.h = state.h[at];
  cell.hu = column.image.momentum(state.hu[at]);
  cell.hv = row.momentum(state.hv[at]);
  cell.b = Flat ? R(0) : fields.bed.row(fields.stored_row(j))[column.stored];
  cell.material = fields.template material_at<Uniform>(column.stored, Uniform ? 0 : fields.stored_row(j));
  return cell;
}

/// Apart from read(), so that the loads are under way for a row before they are needed.
template <class R, int Order, bool Flat, bool Uniform, bool OneD>
SANDSIM_HD void BalancedTile<R, Order, Flat, Uniform, OneD>::find_velocity(Cell& cell) const {
  cell.u = physics::quotient_velocity(cell.hu, cell.h, fields.dry_depth);
  cell.v = physics::quotient_velocity(cell.hv, cell.h, fields.dry_depth);
}

template <class R, int Order, bool Flat, bool Uniform, bool OneD>
SANDSIM_HD auto BalancedTile<R, Order, Flat, Uniform, OneD>::side_x(const Cell& cell, const Reconstruction& r, R half)
    -> Side {
  Side s{cell.h, cell.b, cell.u, cell.v, R(0), r.x.ss, R(0), r.demand, r.Kx, cell.material};
  if constexpr (Order == 2) {
    s.normal = s.normal + half * r.x.su + r.du;
    s.transverse = s.transverse + half * r.x.sv + r.dv;
    s.sh = r.x.sh;
    s.dh = r.dh;
  }
  return s;
}

template <class R, int Order, bool Flat, bool Uniform, bool OneD>
SANDSIM_HD auto BalancedTile<R, Order, Flat, Uniform, OneD>::side_y(const Cell& cell, const Reconstruction& r, R half)
    -> Side {
  Side s{cell.h, cell.b, cell.v, cell.u, R(0), r.y.ss, R(0), r.demand, r.Ky, cell.material};
  if constexpr (Order == 2) {
    s.normal = s.normal + half * r.y.sv + r.dv;
    s.transverse = s.transverse + half * r.y.su + r.du;
    s.sh = r.y.sh;
    s.dh = r.dh;
  }
  return s;
}

template <class R, int Order, bool Flat, bool Uniform, bool OneD>
SANDSIM_HD auto BalancedTile<R, Order, Flat, Uniform, OneD>::reconstruct(const SharedRows& shared, int buffer, int x,
                                                                         int width, const Column& c,
                                                                         const physics::StepParameters<R>& p) const
    -> Reconstruction {
  const int w = x > 0 ? x - 1 : x, e = x + 1 < width ? x + 1 : x;  // the outermost threads' results are not used
  const Cell& own = c.middle;
  physics::Profile3<R> along_x{{shared.at(0, buffer, w), own.h, shared.at(0, buffer, e), R(0), R(0), R(0)},
                               shared.at(1, buffer, w),
                               shared.at(1, buffer, e),
                               shared.at(2, buffer, w),
                               shared.at(2, buffer, e)};
  physics::Profile3<R> along_y{{c.low.h, own.h, c.high.h, R(0), R(0), R(0)}, c.low.u, c.high.u, c.low.v, c.high.v};
  if constexpr (!Flat) {
    along_x.line.b_minus = shared.at(3, buffer, w), along_x.line.b = own.b,
    along_x.line.b_plus = shared.at(3, buffer, e);
    along_y.line.b_minus = c.low.b, along_y.line.b = own.b, along_y.line.b_plus = c.high.b;
  }
  return physics::reconstruct<Order, Flat, OneD>(along_x, along_y, own.u, own.v, own.material, p);
}

template <class R, int Order, bool Flat, bool Uniform, bool OneD>
SANDSIM_HD void BalancedTile<R, Order, Flat, Uniform, OneD>::find_faces(const SharedRows& shared, int x, int i, int j,
                                                                        const TileBounds& tile, Column& c,
                                                                        const physics::StepParameters<R>& p) const {
  constexpr R half = R(0.5f);
  const SideMass& out = fields.out;
  if constexpr (!OneD) {
    c.north = physics::balanced_flux<Flat>(side_y(c.low, c.of_low, half), side_y(c.middle, c.of_middle, -half), p);
    double* side = j == 0 ? out.y_min : (j == fields.ny ? out.y_max : nullptr);
    if (side != nullptr) {
      const double mass = pass_outwards(c.north, j != 0);
      if (tile.holds(i, j == 0 ? j : j - 1)) {
        side[i] = mass;
      }
    }
  }
  const int row = j - 1, w = x > 0 ? x - 1 : x;
  const auto material = fields.template material_at<Uniform>(fields.stored_column(i - 1), fields.stored_row(row));
  c.west = physics::balanced_flux<Flat>(shared.side(row & 1, w, material), side_x(c.low, c.of_low, -half), p);
  double* side = i == 0 ? out.x_min : (i == fields.nx ? out.x_max : nullptr);
  if (side != nullptr) {
    const double mass = pass_outwards(c.west, i != 0);
    if (tile.holds(i == 0 ? i : i - 1, row)) {
      side[row] = mass;
    }
  }
}

template <class R, int Order, bool Flat, bool Uniform, bool OneD>
SANDSIM_HD physics::State<R> BalancedTile<R, Order, Flat, Uniform, OneD>::update(
    const Column& c, const Flux& east, const physics::StepParameters<R>& p) const {
  const Reconstruction& r = c.of_low;
  physics::CellCore<R> core{R(0), r.x.ss, R(0), R(0), R(0), r.G};
  if constexpr (Order == 2) {
    core.sh_x = r.x.sh, core.dh = r.dh;
  }
  if constexpr (!OneD) {
    core.ss_y = r.y.ss;
    if constexpr (Order == 2) {
      core.sh_y = r.y.sh;
    }
  }
  const physics::State<R> old{c.low.h, c.low.hu, c.low.hv};
  return physics::balanced_update<Order, OneD>(old, core, c.west, east, c.south, c.north, c.low.material, p);
}

template <class R, int Order, bool Flat, bool Uniform, bool OneD>
SANDSIM_HD R BalancedTile<R, Order, Flat, Uniform, OneD>::line_speed(const physics::Line<R>& x,
                                                                     const physics::Line<R>& y, R u, R v,
                                                                     const physics::Material<R>& m,
                                                                     const physics::StepParameters<R>& p) const {
  const R slope_x = physics::compact_slope(physics::differences<Flat>(x), p.inverse_dx);
  R slope = physics::absolute(slope_x);
  if constexpr (!OneD) {
    slope = physics::length(slope_x, physics::compact_slope(physics::differences<Flat>(y), p.inverse_dx));
  }
  return physics::balanced_speed<OneD>(x.h, u, v, slope, m, p.g, p.dx, p.dry_depth);
}

template <class R, int Order, bool Flat, bool Uniform, bool OneD>
SANDSIM_HD void BalancedTile<R, Order, Flat, Uniform, OneD>::read_bed(physics::Line<R>& x, physics::Line<R>& y, int i,
                                                                      int j) const {
  if constexpr (!Flat) {
    const R* bed = fields.bed.row(j);
    x.b_minus = bed[fields.stored_column(i - 1)], x.b = bed[i], x.b_plus = bed[fields.stored_column(i + 1)];
    if constexpr (!OneD) {
      y.b_minus = fields.bed.row(fields.stored_row(j - 1))[i], y.b = bed[i];
      y.b_plus = fields.bed.row(fields.stored_row(j + 1))[i];
    }
  }
}

/// Of the new cell in row j = r - 3 of the grid, which the thread has made two rows ago.
template <class R, int Order, bool Flat, bool Uniform, bool OneD>
SANDSIM_HD R BalancedTile<R, Order, Flat, Uniform, OneD>::new_speed(const SharedRows& shared, int x, int i, int j,
                                                                    const Column& c, R h_north,
                                                                    const physics::StepParameters<R>& p) const {
  const physics::State<R>& own = c.made;
  // Behind a wall or an open side stands the edge cell's own depth.
  const auto beyond = [&](bool at_edge, BoundaryKind kind, R inside) {
    return at_edge && kind != BoundaryKind::periodic ? own.h : inside;
  };
  const Boundaries& sides = fields.sides;
  const R zero = R(0);
  physics::Line<R> along_x{beyond(i == 0, sides.x_min, shared.new_depth(j & 1, x - 1)),
                           own.h,
                           beyond(i == fields.nx - 1, sides.x_max, shared.new_depth(j & 1, x + 1)),
                           zero,
                           zero,
                           zero};
  physics::Line<R> along_y{beyond(j == 0, sides.y_min, c.made_low.h),
                           own.h,
                           beyond(j == fields.ny - 1, sides.y_max, h_north),
                           zero,
                           zero,
                           zero};
  read_bed(along_x, along_y, i, j);
  const R u = physics::quotient_velocity(own.hu, own.h, p.dry_depth);
  const R v = physics::quotient_velocity(own.hv, own.h, p.dry_depth);
  return line_speed(along_x, along_y, u, v, fields.template material_at<Uniform>(i, j), p);
}

template <class R, int Order, bool Flat, bool Uniform, bool OneD>
SANDSIM_HD R BalancedTile<R, Order, Flat, Uniform, OneD>::speed(const StateView<R>& state, int i, int j) const {
  const physics::StepParameters<R> p = fields.parameters(R(0));
  const auto depth = [&](int at_i, int at_j) {
    return state.h[state.at(fields.column(at_i).index, fields.row(at_j).index)];
  };
  const std::ptrdiff_t at = state.at(i, j);
  const R h = state.h[at], zero = R(0);
  physics::Line<R> along_x{depth(i - 1, j), h, depth(i + 1, j), zero, zero, zero};
  physics::Line<R> along_y{h, h, h, zero, zero, zero};
  if constexpr (!OneD) {
    along_y.h_minus = depth(i, j - 1), along_y.h_plus = depth(i, j + 1);
  }
  read_bed(along_x, along_y, i, j);
  const R u = physics::quotient_velocity(state.hu[at], h, p.dry_depth);
  const R v = physics::quotient_velocity(state.hv[at], h, p.dry_depth);
  return line_speed(along_x, along_y, u, v, fields.template material_at<Uniform>(i, j), p);
}

template <class R, int Order, bool Flat, bool Uniform, bool OneD>
template <class Block, class Bounds, class Outcomes>
SANDSIM_HD void BalancedTile<R, Order, Flat, Uniform, OneD>::step(Block& block, int from, R dt, int height,
                                                                  const Bounds& bounds, Outcomes& outcomes) const {
  const StateView<R>&present = fields.state(from), &next = fields.state(1 - from);
  const physics::StepParameters<R> p = fields.parameters(dt);
  const int width = block.width();
  typename Block::template PerThread<Column> columns(block);
  const auto rows_of = [&](int strip) {
    return SharedRows{block.template shared<R>() + strip * shared_rows * width, width};
  };
  const auto column_of = [&](const TileBounds& tile, int x) { return tile.i0 - reach + x; };

  block.each([&](int x, int strip) {
    const TileBounds tile = bounds(strip);
    Column& c = columns(x, strip);
    const int i = column_of(tile, x);
    c.image = fields.column(i);
    c.stored = fields.stored_column(i);
    c.ahead = read(present, c, first_row(tile));
  });
  const int rows = Schedule::rows(height);
  for (int n = 0; n < rows; ++n) {
    const Schedule now(n);
    block.each([&](int x, int strip) {
      const TileBounds tile = bounds(strip);
      const SharedRows shared = rows_of(strip);
      Column& c = columns(x, strip);
      const int r = first_row(tile) + n;
      c.low = c.middle, c.middle = c.high, c.of_low = c.of_middle;
      if (now.reads) {
        c.high = c.ahead;
        find_velocity(c.high);
        shared.put_cell(r & 1, x, c.high);
        if (!OneD && n + 1 < rows) {
          c.ahead = read(present, c, r + 1);
        }
      }
      if (now.reconstructs) {
        c.of_middle = reconstruct(shared, (r - 1) & 1, x, width, c, p);
        shared.put_side((r - 1) & 1, x, side_x(c.middle, c.of_middle, R(0.5f)));
      }
      if (now.finds_faces) {
        find_faces(shared, x, column_of(tile, x), r - 1, tile, c, p);
        shared.put_flux(r & 1, x, c.west);
      }
    });
    if (!now.finds_faces && !now.finds_speeds) {
      continue;
    }
    block.each([&](int x, int strip) {
      const TileBounds tile = bounds(strip);
      const SharedRows shared = rows_of(strip);
      Column& c = columns(x, strip);
      TileOutcome<R>& outcome = outcomes(x, strip);
      const int i = column_of(tile, x), r = first_row(tile) + n;
      physics::State<R> made{};
      if (now.updates) {
        made = update(c, shared.flux(r & 1, x + 1 < width ? x + 1 : x), p);
        shared.new_depth(r & 1, x) = made.h;
        if (tile.holds(i, r - 2)) {
          outcome.bits |= step_bits(c.low.h, c.low.hu, c.low.hv, made.h, made.hu, made.hv);
          const std::ptrdiff_t at = next.at(i, r - 2);
          next.h[at] = made.h, next.hu[at] = made.hu, next.hv[at] = made.hv;
        }
      }
      if (now.finds_speeds && tile.holds(i, r - 3)) {
        const R speed = new_speed(shared, x, i, r - 3, c, made.h, p);
        outcome.fastest = physics::maximum(outcome.fastest, speed);
      }
      c.made_low = c.made, c.made = made, c.south = c.north;
    });
  }
}

}  // namespace sandsim::tiles
