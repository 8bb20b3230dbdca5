// A raster: values on a regular grid with its own origin and spacing, as read from a file.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace sandsim {

/// A projected coordinate reference system in metres.
struct Crs {
  std::string name;  // short, as users write it: "EPSG:32632", or the name in the WKT where there is no code
  std::string wkt;   // WKT 1 as GDAL writes it; empty: none is known

  bool known() const { return !wkt.empty(); }
  bool operator==(const Crs&) const = default;
};

/// A regular grid of values, row 0 at the smallest y (readers flip files that start in the north).
/// Values without data are NaN.
struct Raster {
  std::size_t nx = 0;             // columns
  std::size_t ny = 0;             // rows
  double origin_x = 0.0;          // [m] centre of column 0
  double origin_y = 0.0;          // [m] centre of row 0
  double spacing_x = 1.0;         // [m]
  double spacing_y = 1.0;         // [m]
  bool has_georeference = false;  // false: the file carries no position (.npy); it then covers the grid
  std::vector<double> values;     // nx * ny, row major, x fastest
  Crs crs{};                      // unknown unless the file carries it

  double at(std::size_t column, std::size_t row) const { return values[row * nx + column]; }

  /// The first row becomes the last.
  void flip_rows() {
    for (std::size_t row = 0; row < ny / 2; ++row) {
      const auto lower = values.begin() + static_cast<std::ptrdiff_t>(row * nx);
      std::swap_ranges(lower, lower + static_cast<std::ptrdiff_t>(nx),
                       values.begin() + static_cast<std::ptrdiff_t>((ny - 1 - row) * nx));
    }
  }
};

/// Which end of a raster without a position the first row of its file is.
enum class FirstRow { south, north };

/// A raster together with the name under which the scene refers to it.
struct RasterFile {
  std::string file;                       // as written in the scene
  std::shared_ptr<const Raster> data;     // never null in a scene that was read
  std::string place{};                    // "scene.yaml:7:30", for messages; empty in scenes that were not read
  std::optional<FirstRow> first_row{};    // as written in the scene; absent: south, unless the file knows by itself
  std::optional<int> band{};              // likewise; absent: 1
  std::optional<std::string> variable{};  // likewise; absent: the only one
};

}  // namespace sandsim
