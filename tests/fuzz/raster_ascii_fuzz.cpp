// The ESRI ASCII reader either returns a whole raster or throws InputError, whatever the bytes.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "io/raster/read_raster.hpp"
#include "solver/errors.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const sandsim::Raster raster =
        sandsim::read_esri_ascii(std::string_view(reinterpret_cast<const char*>(data), size), "fuzz.asc");
    if (raster.values.empty() || raster.values.size() != raster.nx * raster.ny) {
      std::abort();
    }
  } catch (const sandsim::InputError&) {
  }
  return 0;
}
