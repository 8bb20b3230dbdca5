// Raster files by GDAL.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/gis/gis.hpp"

namespace sandsim::gdal {

/// See Gis::read_raster().
Raster read_raster(const std::filesystem::path& file, const RasterRequest& request);

/// See Gis::encode_raster().
std::vector<EncodedFile> encode_raster(const std::string& stem, RasterFormat format, const Raster& raster,
                                       bool single_precision);

}  // namespace sandsim::gdal
