// Data sets of GDAL, and what is said of a file that cannot be used.
#pragma once

#include <fmt/format.h>
#include <gdal.h>

#include <memory>
#include <string>

#include "io/gis/gdal/errors.hpp"
#include "solver/errors.hpp"

namespace sandsim::gdal {

inline void close(GDALDatasetH dataset) {
  if (dataset != nullptr) {
    GDALClose(dataset);
  }
}
using Dataset = std::unique_ptr<void, decltype(&close)>;

/// Throws InputError.
[[noreturn]] inline void fail(const std::string& name, const std::string& message) {
  throw InputError(fmt::format("{}: {}", name, message));
}

/// Opens a file to be read; `kind` is GDAL_OF_RASTER or GDAL_OF_VECTOR. Throws InputError.
inline Dataset open(const std::string& name, unsigned kind) {
  const Complaints complaints;
  Dataset dataset(GDALOpenEx(name.c_str(), kind | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR, nullptr, nullptr, nullptr),
                  &close);
  if (!dataset) {
    fail(name, fmt::format("GDAL cannot read it as {} ({})", kind == GDAL_OF_RASTER ? "a raster" : "polygons",
                           complaints.text("no reason given")));
  }
  return dataset;
}

}  // namespace sandsim::gdal
