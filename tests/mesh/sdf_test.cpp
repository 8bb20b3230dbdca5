#include <hdf5_hl.h>

#include <filesystem>
#include <numeric>

#include "io/hdf5/hdf5.hpp"
#include "io/mesh/read_sdf.hpp"
#include "tests/mesh/mesh_files.hpp"
#include "tests/support/catch.hpp"

using namespace sandsim;
using sandsim::objects::DistanceGrid;
using sandsim::test::bytes_of;

namespace {

std::string npy(const std::string& shape, const std::string& data, const std::string& order = "False") {
  std::string text = "{'descr': '<f4', 'fortran_order': " + order + ", 'shape': " + shape + "}\n";
  return std::string("\x93NUMPY\x01\0", 8) + static_cast<char>(text.size()) + '\0' + text + data;
}

/// 0, 1, 2, ...
std::vector<double> counted(int count) {
  std::vector<double> values(static_cast<std::size_t>(count));
  std::iota(values.begin(), values.end(), 0.0);
  return values;
}

/// A file in the folder of the build with 0, 1, 2, ... as its data set.
std::filesystem::path hdf5_file(const std::string& file, const std::vector<hsize_t>& shape, bool has_place,
                                const std::string& dataset = "distance", double spacing = 0.5) {
  const std::filesystem::path path = std::filesystem::path(SANDSIM_BINARY_DIR) / ("sdf_test_" + file);
  const hdf5::Session session;
  const hdf5::Handle handle = hdf5::create_file(path);
  std::size_t count = 1;
  for (const hsize_t length : shape) count *= static_cast<std::size_t>(length);
  const std::vector<double> values = counted(static_cast<int>(count));
  H5LTmake_dataset_double(handle.id(), dataset.c_str(), static_cast<int>(shape.size()), shape.data(), values.data());
  if (!has_place) return path;
  const hdf5::Handle samples = hdf5::open_dataset(handle.id(), dataset);
  hdf5::write_attribute(samples.id(), "origin_x", 1.0);
  hdf5::write_attribute(samples.id(), "origin_y", 2.0);
  hdf5::write_attribute(samples.id(), "origin_z", 3.0);
  hdf5::write_attribute(samples.id(), "spacing", spacing);
  return path;
}

std::string npy_error(const std::string& bytes) {
  return test::input_error([&] { read_npy_sdf(bytes, "a.npy"); });
}
std::string sdfgen_error(const std::string& text) {
  return test::input_error([&] { read_sdfgen(text, "a.sdf"); });
}

}  // namespace

TEST_CASE("an array has the dimensions z and y and x and no place") {
  const DistanceGrid grid = read_npy_sdf(npy("(2, 3, 4)", bytes_of<float>(counted(24))), "a.npy");
  CHECK(grid.points == std::array{4, 3, 2});
  CHECK(grid.spacing == 0.0);
  CHECK(view(grid).at(1, 2, 1) == 12 + 8 + 1);
}

TEST_CASE("an array in Fortran order gives the same grid") {
  // The value at (z, y, x) is its place z + 2 (y + 3 x) in the file.
  const DistanceGrid grid = read_npy_sdf(npy("(2, 3, 4)", bytes_of<float>(counted(24)), "True"), "a.npy");
  CHECK(view(grid).at(3, 2, 1) == 1 + 2 * (2 + 3 * 3));
  CHECK(view(grid).at(1, 0, 0) == 6);
}

TEST_CASE("arrays that are no signed distance are errors") {
  CHECK(npy_error(npy("(2, 3)", "")) ==
        "a.npy: the array has shape (2, 3) (a signed distance has three dimensions, z, y and x)");
  CHECK(npy_error(npy("(1, 3, 4)", bytes_of<float>(counted(12)))) ==
        "a.npy: 4 x 3 x 1 samples along x, y, z (two are needed along each axis)");
  CHECK(npy_error(npy("(1000000, 1000000, 1000000)", "")) ==
        "a.npy: 1000000 x 1000000 x 1000000 samples along x, y, z (at most 65536 along an axis and 536870912 in all "
        "are read)");
  CHECK(npy_error(npy("(2, 2, 2)", "abc")) ==
        "a.npy: the header announces 8 values in 32 bytes, but 3 bytes follow it (truncated?)");
  CHECK(npy_error("") == "a.npy: the file is empty");
}

TEST_CASE("samples that are not finite are errors") {
  std::vector<double> values = counted(8);
  values[5] = std::numeric_limits<double>::infinity();
  CHECK(npy_error(npy("(2, 2, 2)", bytes_of<float>(values))) ==
        "a.npy: the value inf at z = 1, y = 0, x = 1 (counted from 0) is not finite in float32");
  CHECK(sdfgen_error("2 2 2 0 0 0 1 nan") == "a.sdf:1:15: a distance = \"nan\" is not finite");
  CHECK(sdfgen_error("2 2 2 0 0 0 1 1e99") == "a.sdf:1:14: the distance is not finite in float32");
}

TEST_CASE("SDFGen's text gives origin and spacing and samples with x fastest") {
  const DistanceGrid grid = read_sdfgen("2 2 3\n-1 0 0.5\n0.25\n0 1 2 3 4 5\n6 7 8 9 10 11\n", "a.sdf");
  CHECK(grid.points == std::array{2, 2, 3});
  CHECK(grid.origin.x == -1.0);
  CHECK(grid.origin.z == 0.5);
  CHECK(grid.spacing == 0.25);
  CHECK(view(grid).at(1, 0, 2) == 9);
}

TEST_CASE("SDFGen's text that is damaged is an error") {
  CHECK(sdfgen_error("") == "a.sdf:1:1: the file ends where the number of samples along x should be (truncated?)");
  CHECK(sdfgen_error("2 2.5 2") == "a.sdf:1:2: 2.5 is no number of samples");
  CHECK(sdfgen_error("2 -2 2") == "a.sdf:1:2: -2 is no number of samples");
  CHECK(sdfgen_error("2 1 2 0 0 0 1") == "a.sdf:1:1: 2 x 1 x 2 samples along x, y, z (two are needed along each axis)");
  CHECK(sdfgen_error("2 2 2 0 0 0 0") == "a.sdf:1:12: the spacing is 0, which is not above 0");
  CHECK(sdfgen_error("2 2 2 0 0 0 1\n1 2 3") == "a.sdf:2:6: the file ends where a distance should be (truncated?)");
  CHECK(sdfgen_error("60000 60000 100 0 0 0 1\n").find("in all are read") != std::string::npos);
  CHECK(sdfgen_error("2 2 2 0 0 0 1\n1 2 3 4 5 6 7 8 9") == "a.sdf:2:17: \"9\" follows the 8 distances");
}

TEST_CASE("an HDF5 file gives samples and place") {
  const std::filesystem::path file = hdf5_file("whole.h5", {2, 3, 4}, true);
  const DistanceGrid grid = read_sdf(file);
  CHECK(grid.points == std::array{4, 3, 2});
  CHECK(view(grid).at(1, 2, 1) == 12 + 8 + 1);
  CHECK(grid.origin.z == 3.0);
  CHECK(grid.spacing == 0.5);
  CHECK(read_sdf(hdf5_file("no_place.h5", {2, 3, 4}, false)).spacing == 0.0);
}

TEST_CASE("HDF5 files that hold no signed distance are errors") {
  const auto error = [](const std::filesystem::path& file) {
    const std::string message = test::input_error([&] { read_sdf(file); });
    return message.substr(std::min(file.string().size(), message.size()));
  };
  CHECK(error(hdf5_file("flat.h5", {3, 4}, true)) ==
        ": distance is no array of numbers with three dimensions, z, y and x");
  CHECK(error(hdf5_file("thin.h5", {1, 3, 4}, true)) ==
        ": 4 x 3 x 1 samples along x, y, z (two are needed along each axis)");
  CHECK(error(hdf5_file("other.h5", {2, 2, 2}, true, "depth")) == ": the file has no data set distance");
  const std::filesystem::path broken = hdf5_file("broken.h5", {2, 2, 2}, true);
  std::filesystem::resize_file(broken, 500);
  CHECK(error(broken).find("could not open the file") != std::string::npos);
  std::filesystem::resize_file(broken, 0);
  CHECK(error(broken).find("could not open the file") != std::string::npos);
  const std::filesystem::path partly = hdf5_file("partly.h5", {2, 2, 2}, true);
  {
    const hdf5::Session session;
    const hdf5::Handle handle = hdf5::open_file(partly, true);
    H5Adelete_by_name(handle.id(), "distance", "origin_y", H5P_DEFAULT);
  }
  CHECK(error(partly) == ": distance has only some of the attributes origin_x, origin_y, origin_z and spacing");
  const std::filesystem::path negative = hdf5_file("negative.h5", {2, 2, 2}, true, "distance", -1.0);
  CHECK(error(negative) == ": the attributes of distance are not a finite origin and a spacing above 0");
}

TEST_CASE("the extension of a signed distance tells its format") {
  CHECK(test::input_error([] { read_sdf("a.vdb"); }) ==
        "a.vdb: the format of the signed distance is unknown (extension \".vdb\"). Known are .npy, .h5 and .sdf");
  CHECK(test::input_error([] { read_sdf("/nonexistent/a.sdf"); }) ==
        "/nonexistent/a.sdf: cannot be opened (no such file)");
}
