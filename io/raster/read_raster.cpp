#include "io/raster/read_raster.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <new>

#include "io/gis/gis.hpp"
#include "io/raster/limits.hpp"
#include "io/raster/source_text.hpp"
#include "solver/errors.hpp"

namespace sandsim {
namespace {

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

}  // namespace

Raster read_raster(const std::filesystem::path& path) {
  const std::string extension = lower_case(path.extension().string());
  const bool ascii = extension == ".asc" || extension == ".txt";
  if (!ascii && extension != ".npy") {
    return gis(path.string()).read_raster(path, {});
  }
  constexpr std::size_t most_bytes_a_value = 32;
  try {
    const std::string bytes = read_file_bytes(path, most_raster_values * most_bytes_a_value);
    return ascii ? read_esri_ascii(bytes, path.string()) : read_npy(bytes, path.string());
  } catch (const std::bad_alloc&) {
    throw DeviceError(fmt::format("{}: the raster does not fit into memory", path.string()));
  }
}

}  // namespace sandsim
