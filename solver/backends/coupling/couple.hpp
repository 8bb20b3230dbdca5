// One object and the sand under it, in one step.
#pragma once

#include "solver/backends/coupling/displace.hpp"
#include "solver/backends/coupling/drag.hpp"

namespace sandsim::coupling {

/// Couples the object of `job` with the state. One that is bed where it covers sand, in a job without covers, does
/// nothing: `changed` counts the columns where it reaches the sand.
template <class R, class Block>
SANDSIM_HD void couple(Block& block, const Job<R>& job, Coupling coupling) {
  const double near = tiles::block_sum<double>(block, job.patch.cells(), [&](double& lane, std::int64_t cell) {
    const int k = static_cast<int>(cell), i = job.i(k), j = job.j(k);
    const double bed = job.bed_at(k), surface = bed + static_cast<double>(job.state.h[job.state.at(i, j)]);
    const bool covered = !job.cover.none() && job.bed.row(j)[i] != job.cover.ground.row(j)[i];
    lane += covered || job.is_near(job.body.lowest, surface) ? 1.0 : 0.0;
  });
  if (near == 0.0 || (coupling != Coupling::drag && job.cover.none())) {  // above the sand, or about to cover it
    block.each([&](int x, int strip) {
      if (x == 0 && strip == 0) {
        *job.sums = CouplingSums{};
        job.sums->changed = near;
      }
    });
  } else if (coupling == Coupling::drag) {
    drag(block, job);
  } else {
    displace(block, job);
  }
}

}  // namespace sandsim::coupling
