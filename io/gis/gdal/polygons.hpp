// Vector files by GDAL.
#pragma once

#include <filesystem>

#include "io/gis/gis.hpp"

namespace sandsim::gdal {

/// See Gis::read_polygons().
PolygonLayer read_polygons(const std::filesystem::path& file, const PolygonRequest& request);

}  // namespace sandsim::gdal
