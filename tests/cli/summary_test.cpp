#include "cli/summary.hpp"

#include <algorithm>
#include <string>

#include "cli/input_files.hpp"
#include "support.hpp"
#include "tests/support/catch.hpp"

using namespace sandsim;
using sandsim::test::contains;

namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

RunReport finished_report() {
  RunReport report;
  report.status = "at rest";
  report.at_rest = true;
  report.stop_time = 0.76;
  report.precision = "float32";
  report.scheme = "balanced";
  report.device = "cpu";
  report.steps = 12345;
  report.ledger.initial = report.ledger.final = 0.5;
  return report;
}

}  // namespace

TEST_CASE("the summary of a run at rest says since when and that nothing was clipped") {
  const std::string text = cli::run_summary(Scene{}, finished_report(), "out: series.h5");
  CHECK(contains(text, "everything still since 0.76 s"));
  CHECK(contains(text, "12,345 steps"));
  CHECK(contains(text, "nothing clipped"));
  CHECK(contains(text, "out: series.h5\n"));
}

TEST_CASE("the summary shows a computed front once however many references there are") {
  RunReport report = finished_report();
  report.errors.push_back({"exact", 1.0, {}, {}, {}, 0.012, {{0.05, 0.5, 0.75}}, {}, ""});
  report.errors.push_back({"measured", 1.0, {}, {}, {}, {}, {{0.05, 0.5, {}}}, {}, "the file is missing"});
  const std::string text = cli::run_summary(Scene{}, report, "");
  CHECK(count(text, "0.05 m deep at 0.5 m") == 1);
  CHECK(contains(text, "against exact: L1 1.2 %; 0.05 m deep -0.25 m off 0.75 m"));
  CHECK(contains(text, "against measured: the file is missing"));
}

TEST_CASE("the summary of a failed run says why") {
  RunReport report = finished_report();
  report.status = "failed";
  report.at_rest = false;
  report.exit_code = ExitCode::numerical_failure;
  report.message = "negative depth";
  CHECK(contains(cli::run_summary(Scene{}, report, ""), "failed: negative depth"));
}

TEST_CASE("the input files of a scene are its rasters in the folder of the scene") {
  Scene scene;
  scene.terrain = {FlatTerrain{}, RasterTerrain{{"dem.asc", nullptr}, 1.0, 0.0}};
  scene.sand.initial = {SandRaster{{"depth.npy", nullptr}, 1.0}};
  scene.sand.friction_coefficient = RasterFile{"/maps/mu.asc", nullptr};
  scene.reference = Reference{};
  scene.reference->measured_profile = Profile{"measured.csv", {}, {}};
  const auto files = cli::input_files(scene, "scenes/valley");
  CHECK(files ==
        std::vector<std::filesystem::path>{"scenes/valley/dem.asc", "scenes/valley/depth.npy", "/maps/mu.asc"});
}

TEST_CASE("the input files have beside them those that say where they lie or belong to them") {
  const test::TemporaryDirectory folder;
  for (const char* name : {"dem.tif", "dem.tfw", "dem.tif.aux.xml", "area.shp", "area.shx", "area.dbf", "area.prj",
                           "area.cpg", "other.prj"}) {
    test::write_text(folder / name, "");
  }
  Scene scene;
  scene.terrain = {RasterTerrain{{"dem.tif", nullptr}}};
  SandPolygon release;
  release.file.file = "area.shp";
  scene.sand.initial = {release};
  scene.sand.friction_angle = ZoneMap{{"soils.gpkg", "", "phi", nullptr, ""}, 0.5};
  std::string names;
  for (const auto& file : cli::input_files(scene, folder.path())) names += file.filename().string() + ' ';
  CHECK(names == "dem.tif dem.tfw dem.tif.aux.xml area.shp area.shx area.dbf area.prj area.cpg soils.gpkg ");
}
