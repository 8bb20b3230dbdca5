// One object and the sand under it, in one step.
#pragma once

#include "solver/backend.hpp"
#include "solver/backends/coupling/displace.hpp"
#include "solver/backends/coupling/drag.hpp"

namespace sandsim::coupling {

/// Couples the object of `job` with the state.
template <class R, class Block>
SANDSIM_HD void couple(Block& block, const Job<R>& job, Coupling coupling) {
  const double near = tiles::block_sum<double>(block, job.patch.cells(), [&](double& lane, std::int64_t cell) {
    const int k = static_cast<int>(cell);
    const double h = static_cast<double>(job.state.h[job.state.at(job.i(k), job.j(k))]);
    lane += job.is_near(job.bed_at(k) + h) ? 1.0 : 0.0;
  });
  if (near == 0.0) {  // the object is above the sand everywhere
    block.each([&](int x, int strip) {
      if (x == 0 && strip == 0) {
        *job.sums = CouplingSums{};
      }
    });
  } else if (coupling == Coupling::drag) {
    drag(block, job);
  } else {
    displace(block, job);
  }
}

/// The cells of the box around an object and one more all around, as far as the grid goes.
Patch patch_around(const objects::Bounds& box, const Grid& grid);

/// A job without memory and without fields, for an object that goes from `before` to `after`.
template <class R>
Job<R> make_job(const Grid& grid, const objects::Object& object, const objects::RigidState& before,
                const objects::RigidState& after) {
  const objects::Bounds box = objects::unite(object.bounds(before), object.bounds(after));
  Job<R> job;
  job.one_d = grid.one_dimensional();
  job.x0 = grid.origin[0], job.y0 = grid.origin[1], job.dx = grid.spacing;
  job.patch = patch_around(box, grid);
  job.lowest = box.low.z;
  job.shape = object.shape();
  job.before = before, job.after = after;
  job.solid = object.coupling() == Coupling::solid;
  job.sample_spacing = object.sample_spacing();
  job.vertical = object.vertical();
  return job;
}

/// What the sums over a patch mean for a grid of spacing dx.
inline ObjectEffect effect_of(const CouplingSums& sums, double dx) {
  const double area = dx * dx;
  return {sums.overlap * area,
          sums.displaced * area,
          {sums.momentum_x * area, sums.momentum_y * area},
          sums.work * area,
          sums.deepest};
}

}  // namespace sandsim::coupling
