#include <algorithm>
#include <cmath>

#include "solver/backends/coupling/couple.hpp"

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

}  // namespace sandsim::coupling
