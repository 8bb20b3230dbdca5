// Rasters and vectors that GDAL reads and writes. GDAL and the hundred libraries that it needs are a module of their
// own (sandsim_gdal.so, built from gdal_module.cpp), opened by the first call of gis(): a run without such files does
// not know of them.
#pragma once

#include <filesystem>
#include <string>

#include "solver/polygons.hpp"
#include "solver/raster.hpp"

namespace sandsim {

/// What a raster file is asked for.
struct RasterRequest {
  int band = 1;
  bool with_values = true;  // false: cells, spacing, origin and CRS only
};

/// What a vector file is asked for.
struct PolygonRequest {
  std::string layer;      // empty: the file has one layer only
  std::string attribute;  // a numeric field whose values are wanted; empty: none
  Crs crs;                // of the grid: polygons in another one are transformed
};

/// The formats that sandsim writes rasters in.
enum class RasterFormat { geotiff, esri_ascii };

/// GDAL as far as sandsim uses it. Every member throws InputError (OutputError: write_raster) with the file, the
/// problem and what to do.
class Gis {
 public:
  virtual ~Gis() = default;

  /// Values are converted to double; NODATA becomes NaN; row 0 is the southern one. Refused: complex values, no such
  /// band, a rotated geotransform, geographic coordinates in degrees, a truncated file.
  virtual Raster read_raster(const std::filesystem::path& file, const RasterRequest& request) = 0;

  /// Refused: an empty layer, other geometries than (multi-)polygons, polygons without area or that cross themselves,
  /// an attribute that is missing, null or text, a file with several layers and none chosen, a layer without a CRS for
  /// a grid with one and the other way round.
  virtual PolygonLayer read_polygons(const std::filesystem::path& file, const PolygonRequest& request) = 0;

  /// What the user calls a CRS: "EPSG:32632", WKT, a PROJ string. Refused: unknown, geographic, other units than
  /// metres.
  virtual Crs find_crs(const std::string& text) = 0;

  /// North up, georeferenced. NaN becomes the NODATA value -9999 in ESRI ASCII, and stays NaN in a GeoTIFF. Values have
  /// the type float32 if `single_precision`, else float64.
  virtual void write_raster(const std::filesystem::path& file, RasterFormat format, const Raster& raster,
                            bool single_precision) = 0;
};

/// Opens the module. Throws InputError where the program was built without GDAL, or the module cannot be opened;
/// `needed_for` says for what, e.g. "dem.tif".
Gis& gis(const std::string& needed_for);

}  // namespace sandsim
