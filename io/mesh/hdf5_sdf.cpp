#include <fmt/format.h>

#include <cmath>

#include "io/hdf5/hdf5.hpp"
#include "io/mesh/read_sdf.hpp"
#include "io/mesh/sdf_shape.hpp"
#include "solver/errors.hpp"

namespace sandsim {

namespace {

/// The grid of a data set without its place.
objects::DistanceGrid read_samples(hid_t dataset, const std::string& name) {
  const std::vector<hsize_t> shape = hdf5::extent(dataset);
  if (shape.size() != 3 || !hdf5::is_numeric(dataset)) {
    throw InputError(fmt::format("{}: distance is no array of numbers with three dimensions, z, y and x", name));
  }
  if (const std::string problem = shape_problem(shape[2], shape[1], shape[0]); !problem.empty()) {
    throw InputError(fmt::format("{}: {}", name, problem));
  }
  objects::DistanceGrid grid;
  grid.points = {static_cast<int>(shape[2]), static_cast<int>(shape[1]), static_cast<int>(shape[0])};
  grid.values.resize(static_cast<std::size_t>(shape[0] * shape[1] * shape[2]));
  hdf5::read(dataset, hdf5::native_type<float>(), grid.values.data());
  for (std::size_t sample = 0; sample < grid.values.size(); ++sample) {
    if (std::isfinite(grid.values[sample])) continue;
    const std::size_t row = sample / shape[2];
    throw InputError(fmt::format("{}: the value {} at z = {}, y = {}, x = {} (counted from 0) is not finite in float32",
                                 name, grid.values[sample], row / shape[1], row % shape[1], sample % shape[2]));
  }
  return grid;
}

void read_place(hid_t dataset, objects::DistanceGrid& grid, const std::string& name) {
  const bool has_place = H5Aexists(dataset, "spacing") > 0;
  for (const char* attribute : {"origin_x", "origin_y", "origin_z"}) {
    if ((H5Aexists(dataset, attribute) > 0) == has_place) continue;
    throw InputError(
        fmt::format("{}: distance has only some of the attributes origin_x, origin_y, origin_z and "
                    "spacing",
                    name));
  }
  if (!has_place) return;
  grid.origin = {hdf5::read_double_attribute(dataset, "origin_x"), hdf5::read_double_attribute(dataset, "origin_y"),
                 hdf5::read_double_attribute(dataset, "origin_z")};
  grid.spacing = hdf5::read_double_attribute(dataset, "spacing");
  const bool is_finite = std::isfinite(grid.origin.x) && std::isfinite(grid.origin.y) && std::isfinite(grid.origin.z);
  if (!is_finite || !(grid.spacing > 0.0) || !std::isfinite(grid.spacing)) {
    throw InputError(fmt::format("{}: the attributes of distance are not a finite origin and a spacing above 0", name));
  }
}

}  // namespace

objects::DistanceGrid read_hdf5_sdf(const std::filesystem::path& path) {
  const std::string name = path.string();
  const hdf5::Session session;
  try {
    const hdf5::Handle file = hdf5::open_file(path, false);
    if (!hdf5::exists(file.id(), "distance")) {
      throw InputError(fmt::format("{}: the file has no data set distance", name));
    }
    const hdf5::Handle dataset = hdf5::open_dataset(file.id(), "distance");
    objects::DistanceGrid grid = read_samples(dataset.id(), name);
    read_place(dataset.id(), grid, name);
    return grid;
  } catch (const hdf5::Failure& failure) {
    throw InputError(fmt::format("{}: {}", name, failure.what()));
  }
}

}  // namespace sandsim
