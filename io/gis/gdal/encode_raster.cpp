#include <cpl_string.h>
#include <cpl_vsi.h>
#include <fmt/format.h>
#include <gdal.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "io/gis/gdal/crs.hpp"
#include "io/gis/gdal/dataset.hpp"
#include "io/gis/gdal/raster.hpp"

namespace sandsim::gdal {
namespace {

constexpr double ascii_no_data = -9999.0;  // Esri's default

GDALDriverH driver(const char* name) {
  const GDALDriverH found = GDALGetDriverByName(name);
  if (found == nullptr) {
    throw InputError(fmt::format("this GDAL has no driver {}", name));
  }
  return found;
}

/// The raster as a data set in memory, north up.
Dataset in_memory(const Raster& raster, double no_data, GDALDataType type) {
  const int nx = static_cast<int>(raster.nx), ny = static_cast<int>(raster.ny);
  Dataset dataset(GDALCreate(driver("MEM"), "", nx, ny, 1, type, nullptr), &close);
  std::array<double, 6> transform{raster.origin_x - 0.5 * raster.spacing_x,
                                  raster.spacing_x,
                                  0.0,
                                  raster.origin_y + (static_cast<double>(raster.ny) - 0.5) * raster.spacing_y,
                                  0.0,
                                  -raster.spacing_y};
  GDALSetGeoTransform(dataset.get(), transform.data());
  if (const SpatialReference reference = reference_of(raster.crs)) {
    GDALSetSpatialRef(dataset.get(), reference.get());
  }
  const GDALRasterBandH band = GDALGetRasterBand(dataset.get(), 1);
  GDALSetRasterNoDataValue(band, no_data);
  std::vector<double> row(raster.nx);
  for (int j = 0; j < ny; ++j) {
    for (std::size_t i = 0; i < raster.nx; ++i) {
      const double value = raster.at(i, raster.ny - 1 - static_cast<std::size_t>(j));
      row[i] = std::isnan(value) ? no_data : value;
    }
    if (GDALRasterIO(band, GF_Write, 0, j, nx, 1, row.data(), nx, 1, GDT_Float64, 0, 0) != CE_None) {
      throw InputError("the raster cannot be copied in memory");
    }
  }
  return dataset;
}

/// Takes a file of GDAL's file system in memory; empty if it is not there.
std::string take(const std::string& path) {
  vsi_l_offset size = 0;
  GByte* const bytes = VSIGetMemFileBuffer(path.c_str(), &size, TRUE);
  const std::string taken = bytes == nullptr
                                ? std::string()
                                : std::string(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size));
  VSIFree(bytes);
  return taken;
}

}  // namespace

std::vector<EncodedFile> encode_raster(const std::string& stem, RasterFormat format, const Raster& raster,
                                       bool single_precision) {
  const bool ascii = format == RasterFormat::esri_ascii;
  const Complaints complaints;
  const Dataset source = in_memory(raster, ascii ? ascii_no_data : std::numeric_limits<double>::quiet_NaN(),
                                   single_precision ? GDT_Float32 : GDT_Float64);
  // Nine and seventeen digits give back every float32 and float64.
  char** options = nullptr;
  if (ascii) {
    options = CSLSetNameValue(options, "SIGNIFICANT_DIGITS", single_precision ? "9" : "17");
  } else {
    options = CSLSetNameValue(options, "COMPRESS", "DEFLATE");
    options = CSLSetNameValue(options, "PREDICTOR", "3");
  }
  const std::string extension = ascii ? ".asc" : ".tif";
  const std::string path = "/vsimem/" + stem + extension;
  Dataset target(
      GDALCreateCopy(driver(ascii ? "AAIGrid" : "GTiff"), path.c_str(), source.get(), TRUE, options, nullptr, nullptr),
      close);
  CSLDestroy(options);
  target.reset();
  std::vector<EncodedFile> files{{stem + extension, take(path)}};
  if (std::string projection = take("/vsimem/" + stem + ".prj"); !projection.empty()) {
    files.push_back({stem + ".prj", std::move(projection)});
  }
  if (files.front().bytes.empty() || complaints.failed()) {
    throw InputError(fmt::format("GDAL cannot make {}{} ({})", stem, extension, complaints.text("no reason given")));
  }
  return files;
}

}  // namespace sandsim::gdal
