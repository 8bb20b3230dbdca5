// The entry of the module.
#include <cpl_conv.h>
#include <gdal.h>

#include "io/gis/gdal/crs.hpp"
#include "io/gis/gdal/polygons.hpp"
#include "io/gis/gdal/raster.hpp"
#include "io/gis/gis.hpp"

namespace sandsim {
namespace {

class GdalModule final : public Gis {
 public:
  GdalModule() {
    // No file opens connections (a VRT may name any), and none is written beside what is read (.aux.xml).
    CPLSetConfigOption("GDAL_PAM_ENABLED", "NO");
    CPLSetConfigOption("GDAL_DISABLE_READDIR_ON_OPEN", "FALSE");
    GDALAllRegister();
    for (const char* driver : {"HTTP", "WMS", "WMTS", "WCS", "PLMOSAIC", "OGCAPI"}) {
      if (const GDALDriverH found = GDALGetDriverByName(driver)) {
        GDALDeregisterDriver(found);
      }
    }
  }

  Raster read_raster(const std::filesystem::path& file, const RasterRequest& request) override {
    return gdal::read_raster(file, request);
  }
  PolygonLayer read_polygons(const std::filesystem::path& file, const PolygonRequest& request) override {
    return gdal::read_polygons(file, request);
  }
  Crs find_crs(const std::string& text) override { return gdal::find_crs(text); }
  bool is_same(const Crs& one, const Crs& other) override {
    return OSRIsSame(gdal::reference_of(one).get(), gdal::reference_of(other).get()) != 0;
  }
  std::vector<EncodedFile> encode_raster(const std::string& stem, RasterFormat format, const Raster& raster,
                                         bool single_precision) override {
    return gdal::encode_raster(stem, format, raster, single_precision);
  }
};

}  // namespace
}  // namespace sandsim

extern "C" sandsim::Gis* sandsim_gis() {
  static sandsim::GdalModule module;
  return &module;
}
