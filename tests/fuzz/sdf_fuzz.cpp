// The readers of signed distances either return a whole grid or throw InputError, whatever the bytes.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "io/mesh/read_sdf.hpp"
#include "solver/errors.hpp"

namespace {

void require_grid(const sandsim::objects::DistanceGrid& grid) {
  std::size_t count = 1;
  for (const int points : grid.points) count *= static_cast<std::size_t>(points);
  if (count < 8 || grid.values.size() != count) std::abort();
  for (const float value : grid.values) {
    if (!std::isfinite(value)) std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  try {
    require_grid(sandsim::read_npy_sdf(bytes, "fuzz.npy"));
  } catch (const sandsim::InputError&) {
  }
  try {
    require_grid(sandsim::read_sdfgen(bytes, "fuzz.sdf"));
  } catch (const sandsim::InputError&) {
  }
  return 0;
}
