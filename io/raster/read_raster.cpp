#include "io/raster/read_raster.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <new>

#include "io/gis/gis.hpp"
#include "io/raster/esri_header.hpp"
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

enum class RasterKind { esri_ascii, npy, other };

/// The content decides; a file that is meant to be one of the formats by its name goes to that reader, whose error
/// says what is wrong with it.
RasterKind kind_of(const std::filesystem::path& path) {
  constexpr std::size_t most_bytes_of_a_first_line = 4096;
  const std::string start = read_file_start(path, most_bytes_of_a_first_line);
  const std::string extension = lower_case(path.extension().string());
  if (start.starts_with("\x93NUMPY") || extension == ".npy") {
    return RasterKind::npy;
  }
  if (begins_like_esri_ascii(start) || extension == ".asc" || extension == ".txt") {
    return RasterKind::esri_ascii;
  }
  return RasterKind::other;
}

/// What the .prj beside an ESRI ASCII grid says; unknown without one, or without GDAL, which understands it.
Crs crs_beside(std::filesystem::path path) {
  std::error_code error;
  path.replace_extension(".prj");
  if (!std::filesystem::is_regular_file(path, error) || !has_gis()) {
    return {};
  }
  constexpr std::size_t most_bytes = 1 << 16;
  try {
    return gis(path.string()).find_crs(read_file_bytes(path, most_bytes));
  } catch (const InputError& problem) {
    throw InputError(fmt::format("{}: {}", path.string(), problem.what()));
  }
}

}  // namespace

Raster read_raster(const std::filesystem::path& path, const RasterRequest& request) {
  constexpr std::size_t most_bytes_a_value = 32;
  const RasterKind kind = kind_of(path);
  try {
    if (kind == RasterKind::other) {
      return gis(path.string()).read_raster(path, request);
    }
    if (request.band != 1 || !request.variable.empty()) {
      throw InputError(fmt::format("{}: {} is asked for, and the file holds one map only", path.string(),
                                   request.variable.empty() ? fmt::format("band {}", request.band)
                                                            : fmt::format("variable '{}'", request.variable)));
    }
    const std::string bytes = read_file_bytes(path, most_raster_values * most_bytes_a_value);
    if (kind == RasterKind::npy) {
      return read_npy(bytes, path.string());
    }
    Raster raster = read_esri_ascii(bytes, path.string());
    raster.crs = crs_beside(path);
    return raster;
  } catch (const std::bad_alloc&) {
    throw DeviceError(fmt::format("{}: the raster does not fit into memory", path.string()));
  }
}

}  // namespace sandsim
