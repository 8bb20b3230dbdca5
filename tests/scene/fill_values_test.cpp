// Values that look like NODATA and are not declared.
#include "io/scene/fill_values.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "tests/scene/support.hpp"
#include "tests/support/catch.hpp"

namespace sandsim {
namespace {

Raster raster_of(std::vector<double> values) {
  const std::size_t nx = values.size();
  return {nx, 1, 0.5, 0.5, 1.0, 1.0, true, std::move(values)};
}

TEST_CASE("values used for NODATA that lie far from all others are found, with their number and the first") {
  const double largest = std::numeric_limits<double>::max();
  for (const double value : {-9999.0, -99999.0, -32767.0, -32768.0, -3.4028234663852886e38, 3.4e38, -largest}) {
    const auto fill = find_fill_value(raster_of({400.0, value, 812.5, value}));
    REQUIRE(fill);
    CHECK(fill->value == value);
    CHECK(fill->count == 2);
    CHECK(fill->column == 1);
    CHECK(fill->row == 0);
  }
  CHECK(find_fill_value(raster_of({-9999.0, -9999.0})));  // nothing else is there
  CHECK(find_fill_value(raster_of({0.0, -9999.0, -32768.0}))->value == -9999.0);
}

TEST_CASE("values among others of their size are data") {
  CHECK_FALSE(find_fill_value(raster_of({-9999.0, -10500.0, -2000.0})));  // a sea floor
  CHECK_FALSE(find_fill_value(raster_of({-9999.0, 3000.0, -5000.0})));
  CHECK_FALSE(find_fill_value(raster_of({1.0, 2.0, std::nan("")})));
  CHECK_FALSE(find_fill_value(raster_of({9999.0, 2.0})));
}

TEST_CASE("a value that looks like NODATA is a warning with the line, the cell and how to declare it") {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "sandsim_fill_values";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "dem.asc") << "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n500 -9999\n501 502\n";
  std::vector<std::string> warnings;
  read_scene_text(
      "grid: {cells: [2, 2], spacing: 1 m}\nterrain: {type: raster, file: dem.asc}\n"
      "sand: {friction_angle: 30 deg, initial: {type: layer, depth: 1 cm}}\ntime: {end: 1 s, frame_interval: 10 ms}\n",
      "s.yaml", folder, std::vector<std::string>{}, &warnings);
  std::filesystem::remove_all(folder);
  REQUIRE(warnings.size() == 1);
  CHECK(
      warnings[0] ==
      "s.yaml:2:25: terrain.file = dem.asc: the raster holds -9999, which many programs write where there is no data "
      "(1 "
      "value, the first in column 1 and row 1, counted from 0 in the south-west). If it means that, declare it: "
      "\"NODATA_value -9999\" in the header of an ESRI ASCII grid, \"gdal_edit.py -a_nodata -9999\" for other rasters, "
      "NaN in a .npy.");
}

}  // namespace
}  // namespace sandsim
