// From the objects of a step to jobs, on the host.
#pragma once

#include <cmath>
#include <vector>

#include "solver/backend.hpp"
#include "solver/backends/coupling/job.hpp"

namespace sandsim::coupling {

/// The cells of the box around an object and one more all around, as far as the grid goes.
Patch patch_around(const objects::Bounds& box, const Grid& grid);

/// An object at the end of a step; nowhere if it has left.
Body make_body(const Grid& grid, const objects::Object& object, const ObjectStep& step);

/// The objects of a step that act on the sand of `patch` as object `own` does, without that one.
std::vector<Body> bodies_beside(const BackendConfig& config, const std::vector<ObjectStep>& steps, std::size_t own,
                                const Patch& patch);

/// Sand is pushed at no more than this many times the speed of shallow waves on a depth of one spacing: what is faster
/// jumps from place to place and strikes nothing.
inline constexpr double most_push = 100.0;

/// A job without memory and without fields.
template <class R>
Job<R> make_job(const BackendConfig& config, const ObjectStep& step) {
  const Grid& grid = config.grid;
  const objects::Object& object = *config.objects[step.object];
  Job<R> job;
  job.one_d = grid.one_dimensional();
  job.sides = config.boundaries;
  job.nx = grid.cells[0], job.ny = grid.cells[1];
  job.x0 = grid.origin[0], job.y0 = grid.origin[1], job.dx = grid.spacing;
  job.patch = patch_around(objects::unite(object.bounds(step.before), object.bounds(step.after)), grid);
  job.body = make_body(grid, object, step);
  job.most_speed = config.gravity > 0.0 ? most_push * std::sqrt(config.gravity * grid.spacing) : HUGE_VAL;
  job.vertical = object.vertical();
  return job;
}

/// What the sums over a patch mean for a grid of spacing dx.
inline ObjectEffect effect_of(const CouplingSums& sums, double dx) {
  const double area = dx * dx;
  return {sums.overlap * area, sums.displaced * area, {sums.momentum_x * area, sums.momentum_y * area},
          sums.work * area,    sums.deepest,          sums.changed > 0.0};
}

}  // namespace sandsim::coupling
