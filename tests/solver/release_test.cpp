// Where the sand of a scene goes: its volume on file, on the grid, outside and blocked.
#include "solver/release.hpp"

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <string>

#include "solver/initial_state.hpp"
#include "tests/support/catch.hpp"

namespace sandsim {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double pi = std::numbers::pi;

Scene scene_of(int nx, int ny, double spacing, std::vector<SandPart> parts) {
  Scene scene;
  scene.grid = {{nx, ny}, spacing, {1000.0, 2000.0}};
  scene.sand.friction_coefficient = 0.5;
  scene.sand.initial = std::move(parts);
  scene.numerics.precision = Precision::float64;
  return scene;
}

Fill depth(double value) {
  return {value, {}};
}

Ring rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

PolygonFile polygons(std::vector<PolygonFeature> features, std::string attribute = "") {
  return {"release.geojson", "", std::move(attribute),
          std::make_shared<PolygonLayer>(PolygonLayer{std::move(features)}), "s.yaml:3:9"};
}

void check_release(const Scene& scene, double file, double grid, double outside, double blocked) {
  const ReleaseReport release = build_initial_state(scene).release;
  // Edges are rounded to 2^-30 of a cell.
  CHECK_THAT(release.file_volume, WithinRel(file, 1e-8));
  CHECK_THAT(release.grid_volume, WithinRel(grid, 1e-8) || WithinAbs(0.0, 1e-12));
  CHECK_THAT(release.outside_volume, WithinAbs(outside, 1e-8 * file));
  CHECK_THAT(release.blocked_volume, WithinAbs(blocked, 1e-8 * file));
}

TEST_CASE("half of a box outside the grid is counted and warned of with both numbers and its line") {
  SandBox box{{900.0, 2100.0}, {1100.0, 2200.0}, depth(1.0)};
  box.place = "s.yaml:4:12";
  const Scene scene = scene_of(50, 50, 10.0, {box});
  check_release(scene, 20000.0, 10000.0, 10000.0, 0.0);
  const std::vector<std::string> warnings = build_initial_state(scene).warnings;
  REQUIRE(warnings.size() == 1);
  CHECK(
      warnings[0] ==
      "s.yaml:4:12: sand.initial = box: 10000 m^3 of 20000 m^3 of sand lie outside the grid and are left out (the grid "
      "spans x from 1000 m to 1500 m and y from 2000 m to 2500 m). Make the grid larger, or the part smaller.");
}

TEST_CASE("every kind of part has its volume on file, on the grid and outside") {
  const std::array<double, 2> corner{1000.0, 2000.0};
  const std::array<double, 2> middle{1050.0, 2050.0};
  check_release(scene_of(10, 10, 10.0, {SandColumn{middle, 20.0, depth(2.0)}}), 800 * pi, 800 * pi, 0, 0);
  check_release(scene_of(10, 10, 10.0, {SandColumn{corner, 20.0, depth(2.0)}}), 800 * pi, 200 * pi, 600 * pi, 0);
  check_release(scene_of(10, 10, 10.0, {SandColumn{middle, 2.0, depth(3.0)}}), 12 * pi, 12 * pi, 0, 0);
  check_release(scene_of(10, 10, 10.0, {SandCone{corner, 20.0, 3.0}}), 400 * pi, 100 * pi, 300 * pi, 0);
  check_release(scene_of(10, 10, 10.0, {SandCone{{1043.0, 2057.0}, 2.0, 3.0}}), 4 * pi, 4 * pi, 0, 0);
  check_release(scene_of(10, 10, 10.0, {SandLayer{depth(0.5)}}), 5000, 5000, 0, 0);
  // In one row all is one spacing wide.
  check_release(scene_of(10, 1, 10.0, {SandBox{{990.0, 0.0}, {1030.0, 1.0}, depth(0.5)}}), 200, 150, 50, 0);
  check_release(scene_of(10, 1, 10.0, {SandColumn{corner, 20.0, depth(0.5)}}), 200, 100, 100, 0);
  check_release(scene_of(10, 1, 10.0, {SandCone{corner, 20.0, 0.5}}), 100, 50, 50, 0);
}

TEST_CASE("sand that is filled up to a level counts where it has ground") {
  const Scene scene = scene_of(10, 10, 10.0, {SandBox{{900.0, 2000.0}, {1020.0, 2100.0}, {{}, 3.0}}});
  check_release(scene, 6000.0, 6000.0, 0.0, 0.0);
  CHECK(build_initial_state(scene).warnings.empty());
}

TEST_CASE("several parts add up in the release") {
  check_release(scene_of(10, 10, 10.0, {SandLayer{depth(0.5)}, SandBox{{900.0, 2000.0}, {1100.0, 2100.0}, depth(1.0)}}),
                25000, 15000, 10000, 0);
}

TEST_CASE("a release surrounded by NODATA keeps its volume on any cells") {
  // A disc of 1.2 m in a raster of 40 x 40 cells of 5 m, and no data about it.
  Raster raster{40, 40, 1002.5, 2002.5, 5.0, 5.0, true, std::vector<double>(1600, nan)};
  double file = 0.0;
  for (std::size_t k = 0; k < 1600; ++k) {
    if (std::hypot(static_cast<double>(k % 40) - 19.5, static_cast<double>(k / 40) - 19.5) < 12.0) {
      raster.values[k] = 1.2;
      file += 1.2 * 25.0;
    }
  }
  const SandRaster part{{"release.asc", std::make_shared<const Raster>(raster)}};
  for (const double spacing : {5.0, 7.5, 3.0, 40.0, 0.8}) {
    Scene scene = scene_of(static_cast<int>(std::ceil(205.0 / spacing)), static_cast<int>(std::ceil(205.0 / spacing)),
                           spacing, {part});
    check_release(scene, file, file, 0.0, 0.0);
    scene.grid.origin = {1000.0 - 0.5 * spacing, 2000.0 - 0.3 * spacing};
    check_release(scene, file, file, 0.0, 0.0);
  }
  check_release(scene_of(20, 40, 5.0, {part}), file, 0.5 * file, 0.5 * file, 0.0);
}

TEST_CASE("a solid object takes sand away, and that is counted") {
  Scene scene = scene_of(2, 1, 1.0, {SandLayer{depth(1.0)}});
  KinematicObject block;
  block.shape = BoxShape{{1.0, 1.0, 4.0}, {}};
  block.position = {1000.5, 2000.5, 0.0};
  block.coupling = Coupling::solid;
  scene.objects = {block};
  check_release(scene, 2.0, 1.0, 0.0, 1.0);
}

TEST_CASE("polygons fill the cells that they cover with one depth or each its own, holes left out") {
  PolygonFeature with_hole{
      {rectangle(1000, 2000, 1030, 2030), {{1010, 2010}, {1010, 2020}, {1020, 2020}, {1020, 2010}}}};
  with_hole.value = 150.0;
  PolygonFeature beyond{{rectangle(1080, 2000, 1120, 2010)}};
  beyond.value = 50.0;

  const SandPolygon one_depth{polygons({with_hole, beyond}), 2.0};
  check_release(scene_of(10, 10, 10.0, {one_depth}), 2 * 800 + 2 * 400, 2 * 800 + 2 * 200, 2 * 200, 0);

  SandPolygon own_depths{polygons({with_hole, beyond, with_hole}, "thickness"), {}, LengthUnit::cm};
  const Scene scene = scene_of(10, 10, 10.0, {own_depths});
  check_release(scene, 2 * 1.5 * 800 + 0.5 * 400, 2 * 1.5 * 800 + 0.5 * 200, 0.5 * 200, 0);
  const std::vector<double> depths = build_initial_state(scene).depth;
  CHECK(depths[0] == 3.0);  // overlapping features add up
  CHECK(depths[11] == 0.0);
  CHECK(depths[8] == 0.5);
}

TEST_CASE("a thickness normal to the slope becomes a vertical depth") {
  SandPolygon part{polygons({{{rectangle(1000, 2000, 1100, 2100)}, nan}}), 1.0};
  part.normal_to_slope = true;
  Scene scene = scene_of(10, 10, 10.0, {part});
  scene.terrain = {PlaneTerrain{pi / 3.0, 0.3, 0.0}};
  for (const double vertical : build_initial_state(scene).depth) {
    CHECK_THAT(vertical, WithinRel(2.0, 1e-12));  // 1 / cos 60 deg
  }
  scene.terrain = {FlatTerrain{}};
  CHECK(build_initial_state(scene).depth == std::vector<double>(100, 1.0));
}

}  // namespace
}  // namespace sandsim
