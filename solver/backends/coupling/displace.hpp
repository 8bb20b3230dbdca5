// `displace` and `solid`: the sand that an object overlaps is moved out of its way, conservatively, and the object is
// bed for the flow: sand piles up against it and runs over it. What fits between the object and the ground is held
// there until the object leaves or the sand beside it has sunk. The sand to be moved goes to the nearest columns that
// no object covers, with the velocity of the object (eq. 20 lets the overlapped part move at that velocity). Columns
// between hand it on from level to level, a level being the number of cells to the nearest free one (after Sumner,
// O'Brien, Hodgins 1999).
#pragma once

#include "solver/backends/coupling/column.hpp"
#include "solver/backends/tiles/block_functions.hpp"

namespace sandsim::coupling {

/// Which scratch rows hold what.
enum DisplaceRow : int {
  amount_row,
  velocity_x_row,
  velocity_y_row,
  out_row,
  taken_row = out_row + 4,
  above_row,
  below_row,
  top_row,
  deep_row
};
static_assert(deep_row < scratch_rows);

/// A bed is no higher than this many spacings above the ground: some shapes have no end.
inline constexpr double highest_bed = 1e4;

/// The largest of the heights that lanes have seen.
struct Highest {
  double height = -objects::endless;

  SANDSIM_HD Highest& operator+=(const Highest& other) {
    height = physics::maximum(height, other.height);
    return *this;
  }
};

/// Up to where sand lies in the columns of the patch that no object covers. [m]
template <class R, class Block>
SANDSIM_HD double highest_sand(Block& block, const Job<R>& job) {
  return tiles::block_sum<Highest>(block, job.patch.cells(),
                                   [&](Highest& lane, std::int64_t k) {
                                     const int cell = static_cast<int>(k);
                                     const Column<R> column = column_at(job, job.i(cell), job.j(cell));
                                     if (!column.covered) {
                                       lane += Highest{column.top()};
                                     }
                                   })
      .height;
}

/// What becomes of a column: which objects cover it, and what sand has to go. An object at rest leaves sand at rest as
/// it is, unless it is solid.
template <class R>
SANDSIM_HD void look_at_column(const Job<R>& job, int cell, double highest) {
  const int i = job.i(cell), j = job.j(cell);
  const Column<R> column = column_at(job, i, j);
  const Hull hull = hull_over(job, cell, column, contact_level(column, highest));
  const bool left_alone = !column.covered && hull.still && !hull.solid && column.rests();
  const Parting<R> parting = part(column, hull);
  const bool covers = hull.lowest < hull.highest && !left_alone && !drains(job, i, j, column, parting);
  const double taken = covers ? parting.taken : 0.0;
  job.levels[cell] = covers ? -1 : 0;
  job.row(above_row)[cell] = static_cast<double>(parting.above);
  job.row(below_row)[cell] = parting.below;
  job.row(top_row)[cell] = physics::minimum(hull.highest, column.ground + highest_bed * job.dx);
  job.row(taken_row)[cell] = taken;
  job.row(amount_row)[cell] = taken;
  const double speed = physics::length(hull.velocity.x, hull.velocity.y);
  const double share = speed > job.most_speed ? job.most_speed / speed : 1.0;
  job.row(velocity_x_row)[cell] = covers ? share * hull.velocity.x : 0.0;
  job.row(velocity_y_row)[cell] = covers && !job.one_d ? share * hull.velocity.y : 0.0;
  job.row(deep_row)[cell] = covers ? physics::maximum(0.0, highest - hull.lowest) : 0.0;
  for (int side = 0; side < 4; ++side) {
    job.row(out_row + side)[cell] = 0.0;
  }
}

/// Share of a column's sand for the neighbour at `side`, one level lower: ahead of the object's motion where there is
/// such a neighbour, else evenly.
template <class R>
SANDSIM_HD double share_of(const Job<R>& job, int cell, int side, double vx, double vy) {
  const int lower = job.levels[cell] - 1;
  double ahead[4], sum = 0.0;
  int count = 0;
  bool open[4];
  for (int k = 0; k < 4; ++k) {
    const int neighbour = job.neighbour(cell, k);
    open[k] = neighbour >= 0 && job.levels[neighbour] == lower;
    const double along = k < 2 ? (k == 0 ? -vx : vx) : (k == 2 ? -vy : vy);
    ahead[k] = open[k] ? physics::maximum(along, 0.0) : 0.0;
    count += open[k] ? 1 : 0;
  }
  sum = (ahead[0] + ahead[1]) + (ahead[2] + ahead[3]);
  if (!open[side]) {
    return 0.0;
  }
  return sum > 0.0 ? ahead[side] / sum : 1.0 / count;
}

/// Numbers the covered columns by their distance from a free one. Returns the largest number.
template <class R, class Block>
SANDSIM_HD int find_levels(Block& block, const Job<R>& job) {
  for (int level = 1;; ++level) {
    each_cell(block, job, [&](int cell) {
      bool touches = false;
      for (int side = 0; side < 4; ++side) {
        const int neighbour = job.neighbour(cell, side);
        touches = touches || (neighbour >= 0 && job.levels[neighbour] == level - 1);
      }
      if (job.levels[cell] < 0 && touches) {
        job.levels[cell] = level;
      }
    });
    const double found = tiles::block_sum<double>(block, job.patch.cells(), [&](double& lane, std::int64_t cell) {
      lane += job.levels[cell] == level ? 1.0 : 0.0;
    });
    if (found == 0.0) {
      return level - 1;
    }
  }
}

/// Hands the sand of one level on to the next lower one, with its momentum.
template <class R, class Block>
SANDSIM_HD void hand_on(Block& block, const Job<R>& job, int level) {
  each_cell(block, job, [&](int cell) {
    const double amount = job.row(amount_row)[cell];
    for (int side = 0; job.levels[cell] == level && amount > 0.0 && side < 4; ++side) {
      job.row(out_row + side)[cell] =
          amount * share_of(job, cell, side, job.row(velocity_x_row)[cell], job.row(velocity_y_row)[cell]);
    }
  });
  each_cell(block, job, [&](int cell) {
    if (job.levels[cell] != level - 1) {
      return;
    }
    double arrives[4] = {}, x[4] = {}, y[4] = {};
    for (int side = 0; side < 4; ++side) {
      const int neighbour = job.neighbour(cell, side);
      if (neighbour >= 0 && job.levels[neighbour] == level) {
        arrives[side] = job.row(out_row + (side ^ 1))[neighbour];  // through the opposite side
        x[side] = arrives[side] * job.row(velocity_x_row)[neighbour];
        y[side] = arrives[side] * job.row(velocity_y_row)[neighbour];
      }
    }
    const double more = (arrives[0] + arrives[1]) + (arrives[2] + arrives[3]);
    if (more > 0.0) {
      double& amount = job.row(amount_row)[cell];
      double &vx = job.row(velocity_x_row)[cell], &vy = job.row(velocity_y_row)[cell];
      const double own = level > 1 ? amount : 0.0;  // a free column has none
      vx = (own * vx + ((x[0] + x[1]) + (x[2] + x[3]))) / (own + more);
      vy = (own * vy + ((y[0] + y[1]) + (y[2] + y[3]))) / (own + more);
      amount = own + more;
    }
  });
}

/// A column's new sand, and its bed.
template <class R>
SANDSIM_HD void settle_column(const Job<R>& job, int cell) {
  const int i = job.i(cell), j = job.j(cell);
  const std::ptrdiff_t at = job.state.at(i, j);
  R &h = job.state.h[at], &hu = job.state.hu[at], &hv = job.state.hv[at];
  R& bed = job.bed.row(j)[i];
  double& buried = job.cover.buried.row(j)[i];
  const double amount = job.row(amount_row)[cell];
  if (job.levels[cell] != 0) {
    // Sand that no free column can be found for stays where it is.
    const double taken = job.levels[cell] > 0 ? job.row(taken_row)[cell] : 0.0;
    const R above = static_cast<R>(job.row(above_row)[cell]);
    buried = job.row(below_row)[cell] - taken;
    if (above != h) {  // what is held has no momentum
      hu = hu * (above / h), hv = hv * (above / h);
      h = above;
    }
    bed = static_cast<R>(job.row(top_row)[cell]);
    return;
  }
  bed = job.cover.ground.row(j)[i];
  if (buried != 0.0 || amount > 0.0) {
    h = static_cast<R>(static_cast<double>(h) + buried + amount);
    buried = 0.0;
  }
  if (amount > 0.0) {
    hu = static_cast<R>(static_cast<double>(hu) + amount * job.row(velocity_x_row)[cell]);
    hv = static_cast<R>(static_cast<double>(hv) + amount * job.row(velocity_y_row)[cell]);
  }
}

/// What a column adds to the sums, before it is settled.
template <class R>
SANDSIM_HD CouplingSums sums_of(const Job<R>& job, int cell) {
  const int i = job.i(cell), j = job.j(cell);
  const Column<R> column = column_at(job, i, j);
  CouplingSums sums;
  sums.overlap = job.row(taken_row)[cell];
  sums.deepest = job.row(deep_row)[cell];
  const bool covers = job.levels[cell] != 0;
  const double taken = job.levels[cell] > 0 ? job.row(taken_row)[cell] : 0.0;
  if (taken > 0.0) {
    const double vx = job.row(velocity_x_row)[cell], vy = job.row(velocity_y_row)[cell];
    const bool moved = !column.covered && column.flowing() > 0.0;
    const double u = moved ? static_cast<double>(column.hu) / column.flowing() : 0.0;
    const double v = moved ? static_cast<double>(column.hv) / column.flowing() : 0.0;
    sums.displaced = taken;
    sums.momentum_x = taken * (vx - u), sums.momentum_y = taken * (vy - v);
    sums.work = sums.momentum_x * vx + sums.momentum_y * vy;
  }
  const bool same = covers ? column.covered && taken == 0.0 && column.bed == static_cast<R>(job.row(top_row)[cell])
                           : !column.covered && !(job.row(amount_row)[cell] > 0.0);
  sums.changed = same ? 0.0 : 1.0;
  return sums;
}

/// The bed around the grid, for a patch beside its sides.
template <class R, class Block>
SANDSIM_HD void renew_ring(Block& block, const Job<R>& job) {
  block.each([&](int x, int strip) {
    const int threads = block.width() * block.strips();
    for (int k = strip * block.width() + x; k < ring_cells(job.nx, job.ny); k += threads) {
      renew_ring_bed(job.bed, job.cover.ground, job.sides, job.nx, job.ny, k);
    }
  });
}

/// Moves the overlapped sand of the patch and makes the covered columns bed. Writes the sums.
template <class R, class Block>
SANDSIM_HD void displace(Block& block, const Job<R>& job) {
  const double highest = highest_sand(block, job);
  each_cell(block, job, [&](int cell) { look_at_column(job, cell, highest); });
  const double all = tiles::block_sum<double>(
      block, job.patch.cells(), [&](double& lane, std::int64_t cell) { lane += job.row(taken_row)[cell]; });
  if (all > 0.0) {
    for (int level = find_levels(block, job); level > 0; --level) {
      hand_on(block, job, level);
    }
  }
  const CouplingSums sums = tiles::block_sum<CouplingSums>(
      block, job.patch.cells(),
      [&](CouplingSums& lane, std::int64_t cell) { lane += sums_of(job, static_cast<int>(cell)); });
  if (sums.changed > 0.0) {
    each_cell(block, job, [&](int cell) { settle_column(job, cell); });
    const Patch& p = job.patch;
    if (p.i0 < halo || p.i1 > job.nx - halo || p.j0 < halo || p.j1 > job.ny - halo) {
      renew_ring(block, job);
    }
  }
  block.each([&](int x, int strip) {
    if (x == 0 && strip == 0) {
      *job.sums = sums;
    }
  });
}

}  // namespace sandsim::coupling
