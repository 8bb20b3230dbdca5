// `displace`: the sand that an object overlaps is moved out of its way, conservatively. The overlapped part of a column
// goes to the nearest columns that the object leaves free, with the velocity of the object (eq. 20 lets the overlapped
// part move at that velocity); the rest of the column stays as it is. Columns between hand it on from level to level,
// a level being the number of cells to the nearest free one (after Sumner, O'Brien, Hodgins 1999).
#pragma once

#include "solver/backends/coupling/job.hpp"
#include "solver/backends/tiles/block_functions.hpp"

namespace sandsim::coupling {

/// Which scratch rows hold what.
enum DisplaceRow : int { amount_row, velocity_x_row, velocity_y_row, out_row, taken_row = out_row + 4 };
static_assert(taken_row < scratch_rows);

/// How much of a column has to go. [m] An object that reaches out of the sand leaves nothing above its underside. Sand
/// over a buried object stays there; only what its motion has newly overlapped goes. An object at rest moves no sand
/// that is at rest. A solid object leaves no sand inside, whatever moves.
template <class R>
SANDSIM_HD double excess(const Job<R>& job, int cell, double h, bool sand_rests, const Contact& now) {
  if (now.overlap <= 0.0 || (sand_rests && now.still() && !job.solid)) {
    return 0.0;
  }
  if (job.solid || now.highest >= job.bed_at(cell) + h) {
    return physics::minimum(now.overlap, h);
  }
  return physics::clamp(now.overlap - job.contact(job.before, cell, h).overlap, 0.0, h);
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

/// Finds what has to go and which columns are free. Returns whether anything has to go.
template <class R, class Block>
SANDSIM_HD bool begin_displacing(Block& block, const Job<R>& job) {
  constexpr int unknown = -1;
  each_cell(block, job, [&](int cell) {
    const std::ptrdiff_t at = job.state.at(job.i(cell), job.j(cell));
    const R h = job.state.h[at];
    const double depth = static_cast<double>(h), surface = job.bed_at(cell) + depth;
    const Contact now = job.contact(job.after, cell, depth);
    const bool rests = job.state.hu[at] == R(0) && job.state.hv[at] == R(0);
    const R left = static_cast<R>(depth - excess(job, cell, depth, rests, now));
    const double taken = depth - static_cast<double>(left);  // exactly what the column loses
    job.row(taken_row)[cell] = taken;
    job.row(amount_row)[cell] = taken;
    job.row(velocity_x_row)[cell] = now.velocity.x;
    job.row(velocity_y_row)[cell] = job.one_d ? 0.0 : now.velocity.y;
    for (int side = 0; side < 4; ++side) {
      job.row(out_row + side)[cell] = 0.0;
    }
    job.levels[cell] = now.lowest < surface + least_gap * job.dx ? unknown : 0;
  });
  const double all = tiles::block_sum<double>(
      block, job.patch.cells(), [&](double& lane, std::int64_t cell) { lane += job.row(taken_row)[cell]; });
  return all > 0.0;
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

/// Takes the sand out of the covered columns and puts it into the free ones.
template <class R, class Block>
SANDSIM_HD void move_sand(Block& block, const Job<R>& job) {
  each_cell(block, job, [&](int cell) {
    const std::ptrdiff_t at = job.state.at(job.i(cell), job.j(cell));
    R &h = job.state.h[at], &hu = job.state.hu[at], &hv = job.state.hv[at];
    const double taken = job.row(taken_row)[cell], amount = job.row(amount_row)[cell];
    if (job.levels[cell] > 0 && taken > 0.0) {
      // What stays is held between the object and the ground. The flow does not know of the object's load: without this
      // the sand beside it would squeeze the rest out underneath.
      h = static_cast<R>(static_cast<double>(h) - taken);
      hu = hv = R(0);
    } else if (job.levels[cell] == 0 && amount > 0.0) {
      h = static_cast<R>(static_cast<double>(h) + amount);
      hu = static_cast<R>(static_cast<double>(hu) + amount * job.row(velocity_x_row)[cell]);
      hv = static_cast<R>(static_cast<double>(hv) + amount * job.row(velocity_y_row)[cell]);
    }
  });
}

/// Moves the overlapped sand of the patch. Writes the sums.
template <class R, class Block>
SANDSIM_HD void displace(Block& block, const Job<R>& job) {
  const bool any = begin_displacing(block, job);
  if (any) {
    for (int level = find_levels(block, job); level > 0; --level) {
      hand_on(block, job, level);
    }
  }
  const CouplingSums sums =
      tiles::block_sum<CouplingSums>(block, job.patch.cells(), [&](CouplingSums& lane, std::int64_t k) {
        const int cell = static_cast<int>(k);
        const std::ptrdiff_t at = job.state.at(job.i(cell), job.j(cell));
        const double h = static_cast<double>(job.state.h[at]);
        const Contact now = job.contact(job.after, cell, h);
        lane.overlap += now.overlap;
        lane.deepest = physics::maximum(lane.deepest, job.bed_at(cell) + h - now.lowest);
        const double taken = any && job.levels[cell] > 0 ? job.row(taken_row)[cell] : 0.0;
        if (taken > 0.0) {
          const double x = taken * (now.velocity.x - static_cast<double>(job.state.hu[at]) / h);
          const double y = taken * (now.velocity.y - static_cast<double>(job.state.hv[at]) / h);
          lane += CouplingSums{0.0, taken, x, y, x * now.velocity.x + y * now.velocity.y, 0.0};
        }
      });
  if (any) {
    move_sand(block, job);
  }
  block.each([&](int x, int strip) {
    if (x == 0 && strip == 0) {
      *job.sums = sums;
    }
  });
}

}  // namespace sandsim::coupling
