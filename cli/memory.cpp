#include "cli/memory.hpp"

#include <fmt/format.h>

#include "cli/machine.hpp"
#include "cli/text.hpp"
#include "solver/errors.hpp"

namespace sandsim::cli {

void require_memory(const Scene& scene) {
  const double word = scene.numerics.precision == Precision::float32 ? 4.0 : 8.0;
  // The initial depth in double precision; two sets of depth and momentum for the step.
  const double least = static_cast<double>(scene.grid.cell_count()) * (8.0 + 6.0 * word);
  const double available = available_memory();
  if (available > 0.0 && least > available) {
    throw DeviceError(
        fmt::format("grid.cells: {} x {} cells need at least {} of memory, and {} are available: make the grid smaller",
                    scene.grid.cells[0], scene.grid.cells[1], format_bytes(least), format_bytes(available)));
  }
}

}  // namespace sandsim::cli
