// Rasters and vectors that GDAL reads and writes. GDAL and the hundred libraries that it needs are a module of their
// own (sandsim_gdal.so, built from io/gis/gdal), opened by the first call of gis(): a run without such files does not
// know of them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "solver/polygons.hpp"
#include "solver/raster.hpp"

namespace sandsim {

/// Which values of a raster file are wanted.
struct RasterRequest {
  int band = 1;          // counted from 1
  std::string variable;  // of a file that holds several (NetCDF); empty: the only one
};

/// Which polygons of a vector file are wanted.
struct PolygonRequest {
  std::string layer;      // empty: the file has one layer only
  std::string attribute;  // a numeric field whose values are wanted; empty: none
  Crs crs;                // of the grid: polygons in another one are transformed
};

/// The formats that rasters are written in.
enum class RasterFormat { geotiff, esri_ascii };

/// The name of a file and what it holds.
struct EncodedFile {
  std::string name;
  std::string bytes;
};

/// GDAL as far as it is used here. Every member throws InputError: the file, the problem and what to do.
class Gis {
 public:
  virtual ~Gis() = default;

  /// Values as double, scale and offset of the band applied; NODATA is NaN; row 0 is the southern one. Refused: complex
  /// values, pictures, values in feet, no such band, no position, a rotated grid, coordinates in degrees or feet, a
  /// truncated file.
  virtual Raster read_raster(const std::filesystem::path& file, const RasterRequest& request) = 0;

  /// Refused: an empty layer, other geometries than (multi-)polygons, polygons without area or that cross themselves;
  /// an attribute that is missing, null or text; several layers and none chosen; a CRS where the grid has none, and no
  /// CRS where the grid has one. A GeoJSON that states no CRS holds WGS 84 (RFC 7946), or the coordinates of a grid
  /// that has none either.
  virtual PolygonLayer read_polygons(const std::filesystem::path& file, const PolygonRequest& request) = 0;

  /// What users call a CRS: "EPSG:32632", WKT, a PROJ string. Refused: unknown, geographic, other units than metres.
  virtual Crs find_crs(const std::string& text) = 0;

  /// Whether the two are the same, however they are written.
  virtual bool is_same(const Crs& one, const Crs& other) = 0;

  /// The raster as a file `stem`.tif or `stem`.asc, and what stands beside it (.prj). North up. NaN is NODATA, which is
  /// -9999 in an ESRI ASCII grid. Values are float32 if `single_precision`, else float64; none is rounded otherwise.
  virtual std::vector<EncodedFile> encode_raster(const std::string& stem, RasterFormat format, const Raster& raster,
                                                 bool single_precision) = 0;
};

/// Whether the program was built with GDAL. Opens nothing.
bool has_gis();

/// The module, opened by the first call. `needed_for` says for what, e.g. the name of a file. Throws InputError where
/// the program was built without GDAL, or the module cannot be opened.
Gis& gis(const std::string& needed_for);

}  // namespace sandsim
