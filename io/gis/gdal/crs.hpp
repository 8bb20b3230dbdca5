// Coordinate reference systems by PROJ, through GDAL.
#pragma once

#include <ogr_srs_api.h>

#include <memory>
#include <string>
#include <type_traits>

#include "solver/raster.hpp"

namespace sandsim::gdal {

/// An owned handle; x is east and y is north whatever the authority's order of axes.
using SpatialReference = std::unique_ptr<std::remove_pointer_t<OGRSpatialReferenceH>, decltype(&OSRRelease)>;

/// The horizontal part of what GDAL found in a file; null stays null.
SpatialReference horizontal(OGRSpatialReferenceH found);

/// Throws InputError unless lengths are metres: `name` stands for the file, `remedy` says what makes metres of it.
void require_metres(OGRSpatialReferenceH reference, const std::string& name, const std::string& remedy);

/// Its name and WKT; null is unknown.
Crs describe(OGRSpatialReferenceH reference);

/// From the WKT of a known one.
SpatialReference reference_of(const Crs& crs);

/// See Gis::find_crs().
Crs find_crs(const std::string& text);

}  // namespace sandsim::gdal
