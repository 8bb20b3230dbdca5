#include "io/export/sdf_files.hpp"

#include <array>

#include "io/output/atomic_hdf5.hpp"

namespace sandsim {

namespace {

using hdf5::Handle;

void write_distance(hid_t file, const objects::DistanceGrid& grid) {
  std::array<hsize_t, 3> shape{};
  for (std::size_t axis = 0; axis < 3; ++axis) shape[axis] = static_cast<hsize_t>(grid.points[2 - axis]);
  const Handle space(H5Screate_simple(3, shape.data(), nullptr), H5Sclose, "size distance");
  const Handle dataset(H5Dcreate2(file, "distance", H5T_IEEE_F32LE, space.id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                       H5Dclose, "create distance");
  hdf5::write_attribute(dataset.id(), "long_name", std::string("signed distance to the sand, negative inside"));
  hdf5::write_attribute(dataset.id(), "units", std::string("m"));
  hdf5::write_attribute(dataset.id(), "origin_x", grid.origin.x);
  hdf5::write_attribute(dataset.id(), "origin_y", grid.origin.y);
  hdf5::write_attribute(dataset.id(), "origin_z", grid.origin.z);
  hdf5::write_attribute(dataset.id(), "spacing", grid.spacing);
  hdf5::write(dataset.id(), hdf5::native_type<float>(), grid.values.data());
}

}  // namespace

void write_hdf5_sdf(const std::filesystem::path& path, const objects::DistanceGrid& grid) {
  write_hdf5_atomically(path, [&grid](hid_t file) { write_distance(file, grid); });
}

}  // namespace sandsim
