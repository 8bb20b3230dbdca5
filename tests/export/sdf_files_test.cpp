#include "io/export/sdf_files.hpp"

#include <unistd.h>

#include <filesystem>

#include "io/mesh/read_sdf.hpp"
#include "io/raster/write_npy.hpp"
#include "solver/errors.hpp"
#include "solver/surface/level_set.hpp"
#include "support.hpp"
#include "tests/support/catch.hpp"

using namespace sandsim;
using namespace sandsim::test;
namespace fs = std::filesystem;

namespace {

objects::DistanceGrid sample_grid() {
  return surface::level_set(sample_mesh(), {0.125, 0.3});
}

}  // namespace

TEST_CASE("a level set in HDF5 reads back with its place") {
  const objects::DistanceGrid grid = sample_grid();
  const fs::path path = fs::temp_directory_path() / ("sandsim_sdf_" + std::to_string(::getpid()) + ".h5");
  write_hdf5_sdf(path, grid);
  const objects::DistanceGrid back = read_sdf(path);
  fs::remove(path);
  CHECK(back.points == grid.points);
  CHECK(back.origin == grid.origin);
  CHECK(back.spacing == grid.spacing);
  CHECK(back.values == grid.values);
}

TEST_CASE("a level set in NumPy's form reads back without its place") {
  const objects::DistanceGrid grid = sample_grid();
  REQUIRE(grid.points[0] != grid.points[2]);
  const objects::DistanceGrid back = read_npy_sdf(npy_bytes(grid.values, grid.points), "a.npy");
  CHECK(back.points == grid.points);
  CHECK(back.values == grid.values);
  CHECK(back.spacing == 0.0);
}

TEST_CASE("a level set that cannot be written is an error of the output") {
  CHECK_THROWS_AS(write_hdf5_sdf("/no/such/folder/a.h5", sample_grid()), OutputError);
}
