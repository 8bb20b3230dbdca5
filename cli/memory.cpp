#include "cli/memory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "cli/machine.hpp"
#include "cli/text.hpp"
#include "solver/errors.hpp"

namespace sandsim::cli {

namespace {

/// Rounded down to two digits, which is as much as "about" promises.
double round_down(double count) {
  const double digit = std::pow(10.0, std::max(0.0, std::floor(std::log10(count)) - 1.0));
  return std::max(1.0, std::floor(count / digit) * digit);
}

/// The grid over the same area whose cells, particles and bytes are `share` of the scene's.
std::string grid_with(const Grid& grid, double share) {
  const double factor = grid.one_dimensional() ? share : std::sqrt(share);
  const double nx = round_down(grid.cells[0] * factor);
  const double ny = grid.one_dimensional() ? 1.0 : round_down(grid.cells[1] * factor);
  return fmt::format("about {:.0f} x {:.0f} cells, with a spacing of {:.3g} m over the same area", nx, ny,
                     grid.spacing * grid.cells[0] / nx);
}

}  // namespace

void require_memory(const Scene& scene, Device device) {
  const Needs needs = needs_of(scene);
  const double available = available_memory();
  const double needed = device == Device::cuda ? needs.host_bytes : needs.memory_bytes();
  const double cells = static_cast<double>(scene.grid.cells[0]) * scene.grid.cells[1];
  const double counted = std::max(cells, particle_number(scene.grid, scene.particles));
  const bool too_many = counted >= most_cells;
  if (!too_many && (available == 0.0 || needed <= available)) {
    return;
  }
  const double share = std::min(available == 0.0 ? 1.0 : available / needed, 0.99 * most_cells / counted);
  const std::string particles =
      scene.particles ? fmt::format(", {} of it for particles,", format_bytes(needs.particle_bytes)) : "";
  throw DeviceError(fmt::format(
      "grid.cells: {} x {} cells need about {} of memory{} and {} of output; {} of memory are available here{}. What "
      "would fit: {}{}",
      scene.grid.cells[0], scene.grid.cells[1], format_bytes(needed), particles, format_bytes(needs.output_bytes),
      format_bytes(available), too_many ? ", and no more than 2^31 cells or particles are counted" : "",
      grid_with(scene.grid, share), scene.particles ? "; or fewer particles" : ""));
}

}  // namespace sandsim::cli
