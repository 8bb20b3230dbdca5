#include "io/gis/gdal/crs.hpp"

#include <cpl_conv.h>
#include <cpl_string.h>
#include <fmt/format.h>
#include <ogr_spatialref.h>

#include <array>
#include <cmath>

#include "io/gis/gdal/errors.hpp"
#include "solver/errors.hpp"

namespace sandsim::gdal {
namespace {

SpatialReference owned(OGRSpatialReferenceH handle) {
  if (handle != nullptr) {
    OSRSetAxisMappingStrategy(handle, OAMS_TRADITIONAL_GIS_ORDER);
  }
  return {handle, OSRRelease};
}

std::string wkt_of(OGRSpatialReferenceH reference) {
  char* text = nullptr;
  const std::string wkt = OSRExportToWkt(reference, &text) == OGRERR_NONE ? text : "";
  CPLFree(text);
  return wkt;
}

/// "EPSG:32632"; empty where it carries no code.
std::string code_of(OGRSpatialReferenceH reference) {
  const char* authority = OSRGetAuthorityName(reference, nullptr);
  const char* code = OSRGetAuthorityCode(reference, nullptr);
  return authority != nullptr && code != nullptr ? fmt::format("{}:{}", authority, code) : std::string();
}

/// The one of PROJ's database that a .prj without a code means, names apart; null if none is as good as certain.
SpatialReference registered_match(OGRSpatialReferenceH reference) {
  constexpr int certain = 90;  // of 100: equivalent, under another name
  int count = 0;
  int* confidence = nullptr;
  OGRSpatialReferenceH* const matches = OSRFindMatches(reference, nullptr, &count, &confidence);
  SpatialReference best = owned(count > 0 && confidence[0] >= certain ? OSRClone(matches[0]) : nullptr);
  OSRFreeSRSArray(matches);
  CPLFree(confidence);
  return best;
}

}  // namespace

SpatialReference horizontal(OGRSpatialReferenceH found) {
  if (found == nullptr) {
    return owned(nullptr);
  }
  SpatialReference reference = owned(OSRClone(found));
  if (OSRIsCompound(reference.get())) {
    OSRStripVertical(reference.get());
  }
  return reference;
}

void require_metres(OGRSpatialReferenceH reference, const std::string& name, const std::string& remedy) {
  if (reference == nullptr) {
    return;
  }
  const std::string crs = describe(reference).name;
  if (OSRIsGeographic(reference) || OSRIsGeocentric(reference)) {
    throw InputError(
        fmt::format("{}: the coordinates are degrees ({}), and the equations need metres. {}", name, crs, remedy));
  }
  char* unit = nullptr;
  if (const double metres = OSRGetLinearUnits(reference, &unit); metres != 1.0) {
    throw InputError(fmt::format("{}: the coordinates are in {} of {:.9g} m ({}), and the equations need metres. {}",
                                 name, unit, metres, crs, remedy));
  }
}

Crs describe(OGRSpatialReferenceH reference) {
  if (reference == nullptr) {
    return {};
  }
  if (std::string name = code_of(reference); !name.empty()) {
    return {std::move(name), wkt_of(reference)};
  }
  if (const SpatialReference match = registered_match(reference); match && !code_of(match.get()).empty()) {
    return {code_of(match.get()), wkt_of(match.get())};
  }
  // Without a code the WKT is the name: it is read again as it is written.
  return {wkt_of(reference), wkt_of(reference)};
}

SpatialReference reference_of(const Crs& crs) {
  return owned(crs.known() ? OSRNewSpatialReference(crs.wkt.c_str()) : nullptr);
}

Crs find_crs(const std::string& text) {
  const Complaints complaints;
  const SpatialReference reference = owned(OSRNewSpatialReference(nullptr));
  constexpr std::array<const char*, 3> options{"ALLOW_NETWORK_ACCESS=NO", "ALLOW_FILE_ACCESS=NO", nullptr};
  auto* const named = OGRSpatialReference::FromHandle(reference.get());  // GDAL 3.6 has no C function with options
  if (named->SetFromUserInput(text.c_str(), options.data()) != OGRERR_NONE) {
    throw InputError(fmt::format("no coordinate reference system is known by it ({}). Write it like EPSG:32632",
                                 complaints.text("PROJ knows none")));
  }
  const SpatialReference flat = horizontal(reference.get());
  require_metres(flat.get(), text, "Name a projected one, like EPSG:32632");
  return describe(flat.get());
}

}  // namespace sandsim::gdal
