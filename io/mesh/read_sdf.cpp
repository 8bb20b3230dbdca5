#include "io/mesh/read_sdf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <new>

#include "io/mesh/sdf_shape.hpp"
#include "io/mesh/tokens.hpp"
#include "io/raster/npy_header.hpp"
#include "io/raster/npy_items.hpp"
#include "io/raster/source_text.hpp"
#include "solver/errors.hpp"

namespace sandsim {

objects::DistanceGrid read_npy_sdf(std::string_view bytes, const std::string& name) {
  const NpyHeader header = read_npy_header(bytes, name);
  const std::vector<std::uint64_t>& shape = header.shape;
  if (shape.size() != 3) {
    throw InputError(fmt::format("{}: the array has shape ({}) (a signed distance has three dimensions, z, y and x)",
                                 name, fmt::join(shape, ", ")));
  }
  if (const std::string problem = shape_problem(shape[2], shape[1], shape[0]); !problem.empty()) {
    throw InputError(fmt::format("{}: {}", name, problem));
  }
  const std::string_view data = bytes.substr(header.data_offset);
  const std::uint64_t count = shape[0] * shape[1] * shape[2];
  if (data.size() != count * header.item_size) {
    throw InputError(fmt::format("{}: the header announces {} values in {} bytes, but {} bytes follow it ({})", name,
                                 count, count * header.item_size, data.size(),
                                 data.size() < count * header.item_size ? "truncated?" : "too many"));
  }
  objects::DistanceGrid grid;
  const auto nx = static_cast<std::size_t>(shape[2]);
  const auto ny = static_cast<std::size_t>(shape[1]);
  const auto nz = static_cast<std::size_t>(shape[0]);
  grid.points = {static_cast<int>(nx), static_cast<int>(ny), static_cast<int>(nz)};
  grid.values.resize(nx * ny * nz);
  for (std::size_t sample = 0; sample < grid.values.size(); ++sample) {
    const std::size_t i = sample % nx;
    const std::size_t j = sample / nx % ny;
    const std::size_t k = sample / (nx * ny);
    const std::size_t place = header.fortran_order ? (i * ny + j) * nz + k : sample;
    const double value = load_npy_item(data.data() + place * header.item_size, header).value;
    grid.values[sample] = static_cast<float>(value);
    if (!std::isfinite(grid.values[sample])) {
      throw InputError(
          fmt::format("{}: the value {} at z = {}, y = {}, x = {} (counted from 0) is not finite in "
                      "float32",
                      name, value, k, j, i));
    }
  }
  return grid;
}

objects::DistanceGrid read_sdfgen(std::string_view text, const std::string& name) {
  Tokens tokens(text, name);
  const SourceText& source = tokens.source();
  const auto count = [&](const char* what) {
    const std::string_view before = tokens.rest();
    const double value = tokens.number(what);
    if (!(value >= 0.0 && value < 1e9 && value == std::floor(value))) {
      source.fail(before, fmt::format("{} is no number of samples", value));
    }
    return static_cast<std::uint64_t>(value);
  };
  const std::uint64_t nx = count("the number of samples along x");
  const std::uint64_t ny = count("the number of samples along y");
  const std::uint64_t nz = count("the number of samples along z");
  if (const std::string problem = shape_problem(nx, ny, nz); !problem.empty()) source.fail(text, problem);
  objects::DistanceGrid grid;
  grid.points = {static_cast<int>(nx), static_cast<int>(ny), static_cast<int>(nz)};
  grid.origin.x = tokens.number("x of the origin");
  grid.origin.y = tokens.number("y of the origin");
  grid.origin.z = tokens.number("z of the origin");
  const std::string_view before = tokens.rest();
  grid.spacing = tokens.number("the spacing");
  if (!(grid.spacing > 0.0)) source.fail(before, fmt::format("the spacing is {}, which is not above 0", grid.spacing));
  for (std::uint64_t sample = 0; sample < nx * ny * nz; ++sample) {
    const std::string_view here = tokens.rest();
    grid.values.push_back(static_cast<float>(tokens.number("a distance")));
    if (!std::isfinite(grid.values.back())) source.fail(here, "the distance is not finite in float32");
  }
  if (const std::string_view more = tokens.next(); !more.empty()) {
    source.fail(more, fmt::format("{} follows the {} distances", in_quotes(more), nx * ny * nz));
  }
  return grid;
}

objects::DistanceGrid read_sdf(const std::filesystem::path& path) {
  constexpr std::size_t most_bytes = std::size_t{1} << 33;
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const bool is_hdf5 = extension == ".h5" || extension == ".hdf5";
  if (extension != ".npy" && extension != ".sdf" && !is_hdf5) {
    throw InputError(
        fmt::format("{}: the format of the signed distance is unknown (extension {}). Known are .npy, .h5 and .sdf",
                    path.string(), extension.empty() ? "missing" : in_quotes(extension)));
  }
  try {
    if (is_hdf5) return read_hdf5_sdf(path);
    const std::string bytes = read_file_bytes(path, most_bytes);
    return extension == ".npy" ? read_npy_sdf(bytes, path.string()) : read_sdfgen(bytes, path.string());
  } catch (const std::bad_alloc&) {
    throw DeviceError(fmt::format("{}: the signed distance does not fit into memory", path.string()));
  }
}

}  // namespace sandsim
