#include <cpl_string.h>
#include <fmt/format.h>
#include <gdal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "io/gis/gdal/crs.hpp"
#include "io/gis/gdal/dataset.hpp"
#include "io/gis/gdal/errors.hpp"
#include "io/gis/gdal/raster.hpp"
#include "io/raster/limits.hpp"

namespace sandsim::gdal {
namespace {

/// The names of the variables that a file holds as data sets of their own, and the full names to open them by.
struct Variables {
  std::vector<std::string> names, full_names;
};

Variables variables_of(GDALDatasetH dataset) {
  Variables variables;
  char** const entries = GDALGetMetadata(dataset, "SUBDATASETS");
  for (int k = 0; k < CSLCount(entries); ++k) {
    const std::string entry = entries[k];
    if (const std::size_t name = entry.find("_NAME="); name != std::string::npos) {
      variables.full_names.push_back(entry.substr(name + 6));
      const std::string& full = variables.full_names.back();
      std::string last = full.substr(full.find_last_of(':') + 1);
      last.erase(0, last.find_first_not_of('/'));
      variables.names.push_back(last);
    }
  }
  return variables;
}

/// The data set of the variable that is asked for; the file's own where it holds just one.
Dataset choose_variable(Dataset file, const std::string& name, const std::string& wanted) {
  const Variables variables = variables_of(file.get());
  if (variables.names.empty() && wanted.empty()) {
    return file;
  }
  const auto found = std::find(variables.names.begin(), variables.names.end(), wanted);
  if (found == variables.names.end()) {
    if (wanted.empty() && GDALGetRasterCount(file.get()) > 0) {
      return file;
    }
    const std::string held = variables.names.empty() ? "the file has no variables"
                                                     : fmt::format("it has {}", fmt::join(variables.names, ", "));
    fail(name, wanted.empty() ? fmt::format("holds several variables. Choose one by \"variable: {}\" ({})",
                                            variables.names.front(), held)
                              : fmt::format("holds no variable '{}' ({})", wanted, held));
  }
  return open(variables.full_names[static_cast<std::size_t>(found - variables.names.begin())], GDAL_OF_RASTER);
}

/// Throws for what is no map of one quantity in metres (or without a unit).
void require_quantity(GDALRasterBandH band, const std::string& name) {
  const GDALDataType type = GDALGetRasterDataType(band);
  if (GDALDataTypeIsComplex(type)) {
    fail(name, fmt::format("the values are complex ({}), and a number is needed. Take a part of them: gdal_translate "
                           "-ot Float32",
                           GDALGetDataTypeName(type)));
  }
  const GDALColorInterp meaning = GDALGetRasterColorInterpretation(band);
  constexpr std::array colours{GCI_PaletteIndex, GCI_RedBand, GCI_GreenBand, GCI_BlueBand, GCI_AlphaBand};
  if (std::find(colours.begin(), colours.end(), meaning) != colours.end()) {
    fail(name, fmt::format("the band holds colours ({}): this is a picture, no map of values",
                           GDALGetColorInterpretationName(meaning)));
  }
  const std::string unit = GDALGetRasterUnitType(band);
  constexpr std::array feet{"ft", "feet", "foot", "US survey foot", "sfoot", "ft-us", "us-ft"};
  if (std::find(feet.begin(), feet.end(), unit) != feet.end()) {
    fail(name, fmt::format("the values are in {}, and metres are needed. Convert them: gdal_calc.py -A {} "
                           "--calc=\"A*0.3048\" --outfile=metres.tif",
                           unit, name));
  }
}

/// For centres in longitude and latitude: the zone of UTM that they lie in.
std::string utm_zone(double longitude, double latitude) {
  const int zone = std::clamp(static_cast<int>(std::floor((longitude + 180.0) / 6.0)) + 1, 1, 60);
  return fmt::format("EPSG:{}", (latitude >= 0.0 ? 32600 : 32700) + zone);
}

/// Cells, spacing, position and CRS of the data set; tells whether the file's first row is the southern one.
bool place(GDALDatasetH dataset, const std::string& name, Raster& raster) {
  raster.nx = static_cast<std::size_t>(GDALGetRasterXSize(dataset));
  raster.ny = static_cast<std::size_t>(GDALGetRasterYSize(dataset));
  if (std::uint64_t{raster.nx} * raster.ny > most_raster_values) {
    fail(name, fmt::format("{} x {} values are too many (at most {} are read). Cut out what is needed: gdal_translate "
                           "-projwin",
                           raster.nx, raster.ny, most_raster_values));
  }
  std::array<double, 6> transform{};
  if (GDALGetGeoTransform(dataset, transform.data()) != CE_None) {
    fail(name,
         fmt::format("the file carries no position. Assign it: gdal_translate -a_srs EPSG:32632 -a_ullr WEST NORTH "
                     "EAST SOUTH {} placed.tif",
                     name));
  }
  raster.has_georeference = true;
  if (transform[2] != 0.0 || transform[4] != 0.0) {
    fail(name, fmt::format("the grid is rotated (geotransform {:.6g}). Make it north up: gdalwarp -r bilinear {} "
                           "north_up.tif",
                           fmt::join(transform, ", "), name));
  }
  if (!(transform[1] > 0.0) || transform[5] == 0.0 || !std::isfinite(transform[5])) {
    fail(name,
         fmt::format("the cells measure {:.6g} x {:.6g} m. Columns run from west to east", transform[1], transform[5]));
  }
  const bool south_first = transform[5] > 0.0;
  const auto rows = static_cast<double>(raster.ny);
  raster.spacing_x = transform[1];
  raster.spacing_y = std::abs(transform[5]);
  raster.origin_x = transform[0] + 0.5 * raster.spacing_x;
  const double south = south_first ? transform[3] : transform[3] + rows * transform[5];
  raster.origin_y = south + 0.5 * raster.spacing_y;
  const SpatialReference reference = horizontal(GDALGetSpatialRef(dataset));
  const double middle_x = transform[0] + 0.5 * static_cast<double>(raster.nx) * transform[1];
  const double middle_y = transform[3] + 0.5 * rows * transform[5];
  require_metres(
      reference.get(), name,
      fmt::format("Project it: gdalwarp -t_srs {} -r bilinear {} metres.tif", utm_zone(middle_x, middle_y), name));
  raster.crs = describe(reference.get());
  return south_first;
}

/// The values of a band in the order of the file; NaN where the file says that there are none.
std::vector<double> values_of(GDALRasterBandH band, const Raster& raster, const std::string& name) {
  const int nx = static_cast<int>(raster.nx), ny = static_cast<int>(raster.ny);
  std::vector<double> values(raster.nx * raster.ny);
  const Complaints complaints;
  const auto require = [&](CPLErr outcome) {
    if (outcome != CE_None || complaints.failed()) {
      fail(name, fmt::format("the values cannot be read, the file is damaged or truncated ({})",
                             complaints.text("no reason given")));
    }
  };
  require(GDALRasterIO(band, GF_Read, 0, 0, nx, ny, values.data(), nx, ny, GDT_Float64, 0, 0));
  if ((GDALGetMaskFlags(band) & GMF_ALL_VALID) == 0) {
    std::vector<unsigned char> mask(values.size());
    require(GDALRasterIO(GDALGetMaskBand(band), GF_Read, 0, 0, nx, ny, mask.data(), nx, ny, GDT_Byte, 0, 0));
    for (std::size_t k = 0; k < values.size(); ++k) {
      values[k] = mask[k] != 0 ? values[k] : std::numeric_limits<double>::quiet_NaN();
    }
  }
  int has_scale = 0, has_offset = 0;
  const double scale = GDALGetRasterScale(band, &has_scale);
  const double offset = GDALGetRasterOffset(band, &has_offset);
  if ((has_scale && scale != 1.0) || (has_offset && offset != 0.0)) {
    std::transform(values.begin(), values.end(), values.begin(), [&](double v) { return v * scale + offset; });
  }
  return values;
}

}  // namespace

Raster read_raster(const std::filesystem::path& file, const RasterRequest& request) {
  const std::string name = file.string();
  const Dataset dataset = choose_variable(open(name, GDAL_OF_RASTER), name, request.variable);
  const int bands = GDALGetRasterCount(dataset.get());
  if (request.band < 1 || request.band > bands) {
    fail(name, fmt::format("there is no band {} (it has {})", request.band,
                           bands == 1 ? "one band, 1" : fmt::format("{} bands, counted from 1", bands)));
  }
  const GDALRasterBandH band = GDALGetRasterBand(dataset.get(), request.band);
  require_quantity(band, name);
  Raster raster;
  const bool south_first = place(dataset.get(), name, raster);
  raster.values = values_of(band, raster, name);
  if (std::all_of(raster.values.begin(), raster.values.end(), [](double value) { return std::isnan(value); })) {
    fail(name, "all values are NODATA (nothing to read)");
  }
  if (!south_first) {
    raster.flip_rows();
  }
  return raster;
}

}  // namespace sandsim::gdal
