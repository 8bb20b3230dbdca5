#include "solver/backends/coupling/prepare.hpp"

#include <algorithm>
#include <cmath>

namespace sandsim::coupling {

Patch patch_around(const objects::Bounds& box, const Grid& grid) {
  if (box.empty()) {
    return {};
  }
  const auto index = [&](double at, std::size_t axis) {
    const double cell = std::floor((at - grid.origin[axis]) / grid.spacing);
    return static_cast<int>(std::clamp(cell, -2.0, static_cast<double>(grid.cells[axis]) + 1.0));
  };
  Patch patch{std::max(0, index(box.low.x, 0) - 1), std::min(grid.cells[0], index(box.high.x, 0) + 2),
              std::max(0, index(box.low.y, 1) - 1), std::min(grid.cells[1], index(box.high.y, 1) + 2)};
  return patch;
}

Body make_body(const Grid& grid, const objects::Object& object, const ObjectStep& step) {
  const objects::Bounds box = object.bounds(step.after);
  Body body;
  body.object = step.object;
  body.shape = object.shape();
  body.state = step.after;
  body.patch = step.has_left ? Patch{} : patch_around(box, grid);
  body.still = step.is_still();
  body.solid = object.coupling() == Coupling::solid;
  body.lowest = step.has_left ? objects::endless : box.low.z;
  body.sample_spacing = object.sample_spacing();
  return body;
}

std::vector<Body> bodies_beside(const BackendConfig& config, const std::vector<ObjectStep>& steps, std::size_t own,
                                const Patch& patch) {
  std::vector<Body> bodies;
  for (const ObjectStep& step : steps) {
    const objects::Object& object = *config.objects[step.object];
    if (step.object == own || step.has_left || object.coupling() == Coupling::drag) {
      continue;
    }
    const Body body = make_body(config.grid, object, step);
    const Patch& p = body.patch;
    if (p.i0 < patch.i1 && patch.i0 < p.i1 && p.j0 < patch.j1 && patch.j0 < p.j1) {
      bodies.push_back(body);
    }
  }
  return bodies;
}

}  // namespace sandsim::coupling
