// `drag`: the paper's section 5. The overlapped part of a column takes on the velocity of the object (eq. 20, 26), and
// the vertical part of the mean velocity pushes the neighbours sideways (eq. 21 to 24).
#pragma once

#include "solver/backends/coupling/job.hpp"
#include "solver/backends/tiles/block_functions.hpp"

namespace sandsim::coupling {

/// Which scratch rows hold what.
enum DragRow : int { mean_x_row, mean_y_row, mean_z_row, overlap_row };

/// Momentum that the vertical velocities w [m/s] of the neighbours push into a cell. [m^2/s]
/// With (hu)'_(i+1) = -dx w_i/2 (eq. 23) a cell gets +dx/2 times the w of the neighbour at its plus side and -dx/2
/// times that of the other, each component from its own axis. Eq. 24 as printed sums both axes into each component.
template <class R>
SANDSIM_HD void push_sideways(const Job<R>& job, int cell, double& hu, double& hv) {
  const auto w = [&](int side) {
    const int neighbour = job.neighbour(cell, side);
    return neighbour >= 0 ? job.row(mean_z_row)[neighbour] : 0.0;
  };
  const double x = 0.5 * job.dx * (w(1) - w(0)), y = job.one_d ? 0.0 : 0.5 * job.dx * (w(3) - w(2));
  const bool printed = job.vertical == VerticalTransfer::printed;
  hu = hu + (printed ? x + y : x);
  hv = job.one_d ? hv : hv + (printed ? x + y : y);
}

template <class R, class Block>
SANDSIM_HD void drag(Block& block, const Job<R>& job) {
  each_cell(block, job, [&](int cell) {
    const std::ptrdiff_t at = job.state.at(job.i(cell), job.j(cell));
    const double h = static_cast<double>(job.state.h[at]);
    const double u = h > 0.0 ? static_cast<double>(job.state.hu[at]) / h : 0.0;
    const double v = h > 0.0 ? static_cast<double>(job.state.hv[at]) / h : 0.0;
    const double bed = job.bed_at(cell);
    const Contact now = job.contact(job.body, cell, bed, bed + h);
    const double part = now.overlap > 0.0 ? now.overlap / h : 0.0;
    job.row(overlap_row)[cell] = now.overlap;
    job.row(mean_x_row)[cell] = u + part * (now.velocity.x - u);
    job.row(mean_y_row)[cell] = job.one_d ? v : v + part * (now.velocity.y - v);
    job.row(mean_z_row)[cell] = part * now.velocity.z;
  });
  const bool transfers = job.vertical != VerticalTransfer::none;
  const auto new_momentum = [&](int cell, double h, double hu, double hv, double& x, double& y) {
    const bool overlapped = job.row(overlap_row)[cell] > 0.0;
    x = overlapped ? h * job.row(mean_x_row)[cell] : hu;
    y = overlapped ? h * job.row(mean_y_row)[cell] : hv;
    if (transfers && h > 0.0) {
      push_sideways(job, cell, x, y);
    }
  };
  const CouplingSums sums =
      tiles::block_sum<CouplingSums>(block, job.patch.cells(), [&](CouplingSums& lane, std::int64_t k) {
        const int cell = static_cast<int>(k);
        const std::ptrdiff_t at = job.state.at(job.i(cell), job.j(cell));
        const double h = static_cast<double>(job.state.h[at]);
        const double hu = static_cast<double>(job.state.hu[at]), hv = static_cast<double>(job.state.hv[at]);
        double x, y;
        new_momentum(cell, h, hu, hv, x, y);
        const double bed = job.bed_at(cell);
        const Contact now = job.contact(job.body, cell, bed, bed + h);
        const double dx = x - hu, dy = y - hv;
        lane +=
            CouplingSums{now.overlap,
                         0.0,
                         dx,
                         dy,
                         dx * now.velocity.x + dy * now.velocity.y,
                         bed + h - now.lowest,
                         static_cast<R>(x) != job.state.hu[at] || static_cast<R>(y) != job.state.hv[at] ? 1.0 : 0.0};
      });
  each_cell(block, job, [&](int cell) {
    const std::ptrdiff_t at = job.state.at(job.i(cell), job.j(cell));
    const double hu = static_cast<double>(job.state.hu[at]), hv = static_cast<double>(job.state.hv[at]);
    double x, y;
    new_momentum(cell, static_cast<double>(job.state.h[at]), hu, hv, x, y);
    if (x != hu) {
      job.state.hu[at] = static_cast<R>(x);
    }
    if (y != hv) {
      job.state.hv[at] = static_cast<R>(y);
    }
  });
  block.each([&](int x, int strip) {
    if (x == 0 && strip == 0) {
      *job.sums = sums;
    }
  });
}

}  // namespace sandsim::coupling
