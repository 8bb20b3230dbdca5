#include "io/gis/gdal/polygons.hpp"

#include <fmt/format.h>
#include <gdal.h>
#include <ogr_api.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <memory>

#include "io/gis/gdal/crs.hpp"
#include "io/gis/gdal/dataset.hpp"
#include "io/gis/gdal/errors.hpp"

namespace sandsim::gdal {
namespace {

using Geometry = std::unique_ptr<std::remove_pointer_t<OGRGeometryH>, decltype(&OGR_G_DestroyGeometry)>;
using Feature = std::unique_ptr<std::remove_pointer_t<OGRFeatureH>, decltype(&OGR_F_Destroy)>;
using Transformation =
    std::unique_ptr<std::remove_pointer_t<OGRCoordinateTransformationH>, decltype(&OCTDestroyCoordinateTransformation)>;

OGRLayerH choose_layer(GDALDatasetH dataset, const std::string& name, const std::string& wanted) {
  std::vector<std::string> names;
  for (int k = 0; k < GDALDatasetGetLayerCount(dataset); ++k) {
    names.emplace_back(OGR_L_GetName(GDALDatasetGetLayer(dataset, k)));
  }
  if (names.empty()) {
    fail(name, "the file has no layers");
  }
  if (wanted.empty() && names.size() > 1) {
    fail(name, fmt::format("the file has several layers. Choose one by \"layer: {}\" (it has {})", names.front(),
                           fmt::join(names, ", ")));
  }
  const auto found = wanted.empty() ? names.begin() : std::find(names.begin(), names.end(), wanted);
  if (found == names.end()) {
    fail(name, fmt::format("there is no layer '{}' (the file has {})", wanted, fmt::join(names, ", ")));
  }
  return GDALDatasetGetLayer(dataset, static_cast<int>(found - names.begin()));
}

/// The number of the attribute's field; -1 if none is asked for.
int find_attribute(OGRLayerH layer, const std::string& name, const std::string& wanted) {
  if (wanted.empty()) {
    return -1;
  }
  const OGRFeatureDefnH fields = OGR_L_GetLayerDefn(layer);
  std::vector<std::string> names;
  for (int k = 0; k < OGR_FD_GetFieldCount(fields); ++k) {
    const OGRFieldDefnH field = OGR_FD_GetFieldDefn(fields, k);
    names.emplace_back(OGR_Fld_GetNameRef(field));
    if (names.back() != wanted) {
      continue;
    }
    const OGRFieldType type = OGR_Fld_GetType(field);
    if (type != OFTInteger && type != OFTInteger64 && type != OFTReal) {
      fail(name, fmt::format("the attribute '{}' is no number (its type is {})", wanted, OGR_GetFieldTypeName(type)));
    }
    return k;
  }
  fail(name,
       fmt::format("there is no attribute '{}' ({})", wanted,
                   names.empty() ? "the layer has none" : fmt::format("the layer has {}", fmt::join(names, ", "))));
}

/// A GeoJSON file may state a CRS by the member "crs" of older editions; without it GDAL says WGS 84.
bool states_crs(GDALDatasetH dataset, const std::filesystem::path& file) {
  if (std::string(GDALGetDriverShortName(GDALGetDatasetDriver(dataset))) != "GeoJSON") {
    return true;
  }
  std::ifstream stream(file, std::ios::binary);
  const std::string text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  return text.find("\"crs\"") != std::string::npos;
}

/// From the layer's CRS to the grid's; null where they are the same, or neither has one.
Transformation transformation(GDALDatasetH dataset, OGRLayerH layer, const std::filesystem::path& file,
                              const Crs& grid) {
  const std::string name = file.string();
  const SpatialReference from = horizontal(OGR_L_GetSpatialRef(layer));
  Transformation none(nullptr, &OCTDestroyCoordinateTransformation);
  if (!grid.known()) {
    if (from && states_crs(dataset, file)) {
      const Crs crs = describe(from.get());
      fail(name, fmt::format("the layer is in {}, and the grid has no CRS. State it: grid.crs: {}", crs.name,
                             OSRIsProjected(from.get()) ? crs.name : "EPSG:32632 (say)"));
    }
    return none;
  }
  if (!from) {
    fail(name, fmt::format("the layer has no CRS, and the grid is in {}. Assign the one that it is in: ogr2ogr -a_srs "
                           "{} assigned.gpkg {}",
                           grid.name, grid.name, name));
  }
  const SpatialReference to = reference_of(grid);
  if (OSRIsSame(from.get(), to.get())) {
    return none;
  }
  if (OSRIsGeographic(from.get()) && !states_crs(dataset, file)) {
    OGREnvelope box{};
    if (OGR_L_GetExtent(layer, &box, TRUE) == OGRERR_NONE &&
        (std::max(std::abs(box.MinX), std::abs(box.MaxX)) > 360.0 ||
         std::max(std::abs(box.MinY), std::abs(box.MaxY)) > 90.0)) {
      fail(name, fmt::format("a GeoJSON without a member \"crs\" holds degrees, and these are none (x from {:.9g} to "
                             "{:.9g}). Assign the CRS: ogr2ogr -a_srs {} assigned.gpkg {}",
                             box.MinX, box.MaxX, grid.name, name));
    }
  }
  const Complaints complaints;
  Transformation to_grid(OCTNewCoordinateTransformation(from.get(), to.get()), &OCTDestroyCoordinateTransformation);
  if (!to_grid) {
    fail(name, fmt::format("PROJ knows no way from {} to {} ({})", describe(from.get()).name, grid.name,
                           complaints.text("no reason given")));
  }
  return to_grid;
}

double signed_area(const Ring& ring) {
  double twice = 0.0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    // From the first corner, so that far coordinates do not cancel.
    const auto& a = ring[k];
    const auto& b = ring[(k + 1) % ring.size()];
    twice += (a[0] - ring[0][0]) * (b[1] - ring[0][1]) - (b[0] - ring[0][0]) * (a[1] - ring[0][1]);
  }
  return 0.5 * twice;
}

/// The corners of a line, the last one left out, which repeats the first.
Ring ring_of(OGRGeometryH line, bool counter_clockwise) {
  Ring ring;
  for (int k = 0; k + 1 < OGR_G_GetPointCount(line); ++k) {
    ring.push_back({OGR_G_GetX(line, k), OGR_G_GetY(line, k)});
  }
  if (!ring.empty() && (signed_area(ring) > 0.0) != counter_clockwise) {
    std::reverse(ring.begin(), ring.end());
  }
  return ring;
}

void add_polygon(OGRGeometryH polygon, std::vector<Ring>& rings) {
  for (int k = 0; k < OGR_G_GetGeometryCount(polygon); ++k) {
    rings.push_back(ring_of(OGR_G_GetGeometryRef(polygon, k), k == 0));
  }
}

/// Reads the features of one layer.
class FeatureReader {
 public:
  FeatureReader(std::string name, int attribute, Transformation to_grid)
      : name_(std::move(name)), attribute_(attribute), to_grid_(std::move(to_grid)) {}

  PolygonFeature read(OGRFeatureH feature) const {
    const std::string id = fmt::format("feature {}", OGR_F_GetFID(feature));
    PolygonFeature read;
    if (attribute_ >= 0) {
      read.value = value_of(feature, id);
    }
    const Geometry geometry = geometry_of(feature, id);
    if (wkbFlatten(OGR_G_GetGeometryType(geometry.get())) == wkbPolygon) {
      add_polygon(geometry.get(), read.rings);
    } else {
      for (int k = 0; k < OGR_G_GetGeometryCount(geometry.get()); ++k) {
        add_polygon(OGR_G_GetGeometryRef(geometry.get(), k), read.rings);
      }
    }
    return read;
  }

 private:
  double value_of(OGRFeatureH feature, const std::string& id) const {
    const char* field = OGR_Fld_GetNameRef(OGR_F_GetFieldDefnRef(feature, attribute_));
    if (!OGR_F_IsFieldSetAndNotNull(feature, attribute_)) {
      fail(name_, fmt::format("the attribute '{}' of {} has no value", field, id));
    }
    const double value = OGR_F_GetFieldAsDouble(feature, attribute_);
    if (!std::isfinite(value)) {
      fail(name_, fmt::format("the attribute '{}' of {} is not finite ({})", field, id, value));
    }
    return value;
  }

  /// A polygon or multi-polygon with straight edges, in the grid's coordinates, valid and with an area.
  Geometry geometry_of(OGRFeatureH feature, const std::string& id) const {
    const OGRGeometryH stored = OGR_F_GetGeometryRef(feature);
    if (stored == nullptr || OGR_G_IsEmpty(stored)) {
      fail(name_, fmt::format("{} has no geometry", id));
    }
    Geometry geometry(OGR_G_GetLinearGeometry(stored, 0.0, nullptr), &OGR_G_DestroyGeometry);
    const OGRwkbGeometryType type = geometry ? wkbFlatten(OGR_G_GetGeometryType(geometry.get())) : wkbUnknown;
    if (type != wkbPolygon && type != wkbMultiPolygon) {
      fail(name_, fmt::format("{} is no polygon (its geometry is {}). Release areas and zones are polygons", id,
                              OGR_G_GetGeometryName(stored)));
    }
    require_valid(geometry.get(), id);
    if (to_grid_) {
      transform(geometry.get(), id);
    }
    return geometry;
  }

  void require_valid(OGRGeometryH geometry, const std::string& id) const {
    const Complaints complaints;
    if (!OGR_G_IsValid(geometry)) {
      fail(name_, fmt::format("{} is no valid polygon ({}). Repair it: ogr2ogr -makevalid repaired.gpkg {}", id,
                              complaints.text("its rings cross or overlap"), name_));
    }
    if (!(OGR_G_Area(geometry) > 0.0)) {
      fail(name_, fmt::format("{} has no area", id));
    }
  }

  /// Straight edges become curves in another CRS: they are cut into pieces first.
  void transform(OGRGeometryH geometry, const std::string& id) const {
    constexpr double pieces = 64.0;  // along the longer side: a curve's rise falls with the square of their length
    OGREnvelope box{};
    OGR_G_GetEnvelope(geometry, &box);
    OGR_G_Segmentize(geometry, std::max(box.MaxX - box.MinX, box.MaxY - box.MinY) / pieces);
    const Complaints complaints;
    if (OGR_G_Transform(geometry, to_grid_.get()) != OGRERR_NONE) {
      fail(name_,
           fmt::format("{} cannot be transformed to the CRS of the grid ({})", id, complaints.text("no reason given")));
    }
  }

  std::string name_;
  int attribute_ = -1;
  Transformation to_grid_;
};

}  // namespace

PolygonLayer read_polygons(const std::filesystem::path& file, const PolygonRequest& request) {
  const std::string name = file.string();
  const Dataset dataset = open(name, GDAL_OF_VECTOR);
  const OGRLayerH layer = choose_layer(dataset.get(), name, request.layer);
  const int attribute = find_attribute(layer, name, request.attribute);
  const FeatureReader reader(name, attribute, transformation(dataset.get(), layer, file, request.crs));
  PolygonLayer polygons;
  const Complaints complaints;
  OGR_L_ResetReading(layer);
  while (true) {
    const Feature feature(OGR_L_GetNextFeature(layer), &OGR_F_Destroy);
    if (!feature) {
      break;
    }
    polygons.features.push_back(reader.read(feature.get()));
  }
  if (complaints.failed()) {
    fail(name, fmt::format("the features cannot be read, the file is damaged or truncated ({})",
                           complaints.text("no reason given")));
  }
  if (polygons.features.empty()) {
    fail(name, fmt::format("the layer '{}' is empty (it has no features)", OGR_L_GetName(layer)));
  }
  return polygons;
}

}  // namespace sandsim::gdal
