#include <fmt/format.h>

#include <cmath>

#include "io/raster/limits.hpp"
#include "io/raster/npy_header.hpp"
#include "io/raster/npy_items.hpp"
#include "io/raster/read_raster.hpp"
#include "solver/errors.hpp"

namespace sandsim {
namespace {

std::string shape_text(const std::vector<std::uint64_t>& shape) {
  return fmt::format("({}{})", fmt::join(shape, ", "), shape.size() == 1 ? "," : "");
}

/// The raster without its values. Throws if the shape is not that of a raster or does not fit the file.
Raster shape_raster(const NpyHeader& header, std::size_t data_bytes, const std::string& name) {
  const std::vector<std::uint64_t>& shape = header.shape;
  if (shape.empty() || shape.size() > 2) {
    throw InputError(
        fmt::format("{}: the array has shape {} (a raster has two dimensions, y and x; or one, which is a row)", name,
                    shape_text(shape)));
  }
  const std::uint64_t ny = shape.size() == 2 ? shape[0] : 1;
  const std::uint64_t nx = shape.back();
  if (nx == 0 || ny == 0) {
    throw InputError(fmt::format("{}: the array has shape {} (it is empty)", name, shape_text(shape)));
  }
  if (nx > most_raster_values || ny > most_raster_values || nx * ny > most_raster_values) {
    throw InputError(fmt::format("{}: the array has shape {}, which is too large (at most {} values are read)", name,
                                 shape_text(shape), most_raster_values));
  }
  const std::uint64_t expected = nx * ny * header.item_size;
  if (data_bytes != expected) {
    throw InputError(fmt::format("{}: the header announces {} values in {} bytes, but {} bytes follow it ({})", name,
                                 nx * ny, expected, data_bytes, data_bytes < expected ? "truncated?" : "too many"));
  }
  Raster raster;
  raster.nx = static_cast<std::size_t>(nx);
  raster.ny = static_cast<std::size_t>(ny);
  return raster;
}

}  // namespace

Raster read_npy(std::string_view bytes, const std::string& name) {
  const NpyHeader header = read_npy_header(bytes, name);
  const std::string_view data = bytes.substr(header.data_offset);
  Raster raster = shape_raster(header, data.size(), name);
  raster.values.resize(raster.nx * raster.ny);
  bool any_data = false;
  for (std::size_t row = 0; row < raster.ny; ++row) {
    for (std::size_t column = 0; column < raster.nx; ++column) {
      const std::size_t place = header.fortran_order ? column * raster.ny + row : row * raster.nx + column;
      const auto [value, exact] = load_npy_item(data.data() + place * header.item_size, header);
      if (std::isinf(value) || !exact) {
        throw InputError(fmt::format(
            "{}: the value {} in row {}, column {} (counted from 0) {}", name, value, row, column,
            exact ? "is not finite. Mark missing data by nan" : "is too large for an exact double (over 2^53)"));
      }
      raster.values[row * raster.nx + column] = value;
      any_data = any_data || !std::isnan(value);
    }
  }
  if (!any_data) {
    throw InputError(fmt::format("{}: all {} values are nan (nothing to read)", name, raster.values.size()));
  }
  return raster;
}

}  // namespace sandsim
