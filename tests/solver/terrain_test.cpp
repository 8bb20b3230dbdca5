// Terrain without data, and maps of the material.
#include "solver/terrain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>

#include "solver/simulation.hpp"
#include "tests/solver/support.hpp"
#include "tests/support/catch.hpp"

namespace sandsim {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Scene scene_of(int nx, int ny, std::vector<double> bed, Nodata nodata) {
  Scene scene;
  scene.grid = {{nx, ny}, 1.0, {0.0, 0.0}};
  scene.sand.friction_coefficient = 0.5;
  scene.numerics.precision = Precision::float64;
  const Raster raster{
      static_cast<std::size_t>(nx), static_cast<std::size_t>(ny), 0.5, 0.5, 1.0, 1.0, true, std::move(bed)};
  scene.terrain = {RasterTerrain{{"dem.asc", std::make_shared<const Raster>(raster), "s.yaml:2:24"}, 1.0, 0.0, nodata}};
  return scene;
}

TEST_CASE("terrain without data is an error that tells the line, the cells and the ways out") {
  CHECK(
      test::initial_error(scene_of(3, 2, {1, nan, 3, 4, 5, nan}, Nodata::error)) ==
      "s.yaml:2:24: terrain.file = dem.asc: the raster has no data (outside its edges, or NODATA) in 2 of 6 cells, the "
      "first is cell (1, 0) at x = 1.5 m, y = 0.5 m with nan. Keep the grid to the data (grid.cells, grid.origin), or "
      "write \"nodata: wall\" to keep the sand out there, or \"nodata: nearest\" to take the nearest value");
}

TEST_CASE("terrain without data takes the nearest value") {
  CHECK(build_initial_state(scene_of(4, 1, {1, nan, nan, 4}, Nodata::nearest)).bed == std::vector<double>{1, 1, 4, 4});
  Scene beyond = scene_of(2, 1, {1, 4}, Nodata::nearest);
  beyond.grid.cells = {4, 1};
  CHECK(build_initial_state(beyond).bed == std::vector<double>{1, 4, 4, 4});
}

TEST_CASE("terrain without any data is an error in every way") {
  for (const Nodata nodata : {Nodata::error, Nodata::wall, Nodata::nearest}) {
    CHECK(test::initial_error(scene_of(2, 1, {nan, nan}, nodata)) ==
          "s.yaml:2:24: terrain.file = dem.asc: the raster has no data in any cell of the grid");
  }
}

TEST_CASE("a wall stands above all ground and sand by all that sand can fall") {
  Scene scene = scene_of(4, 1, {5, nan, 2, 3}, Nodata::wall);
  scene.sand.initial = {SandBox{{3.0, 0.0}, {4.0, 1.0}, {4.0, {}}, {4.0, 0.0}}};
  scene.gravity = 8.0;
  // Highest 3 + 4 and 4^2/16 of velocity head, 6 above the lowest; one cell more.
  CHECK(build_initial_state(scene).bed == std::vector<double>{5, 8 + 6 + 1, 2, 3});
  // All of a source of 10 m^3 in one cell would be more than a slope of 1/2 through the grid of sqrt(17) cells.
  scene.sand.sources = {SandSource{{2.5, 0.5}, 0.1, 1.0, 0.0, 10.0}};
  const double heap = 0.5 * std::sqrt(17.0);
  CHECK_THAT(build_initial_state(scene).bed[1], WithinRel(15 + 2 * heap, 1e-15));
}

TEST_CASE("sand on walls is left out with a warning, and a layer or a level does without") {
  Scene scene = scene_of(4, 1, {0, nan, 0, 0}, Nodata::wall);
  SandBox box{{0.0, 0.0}, {3.0, 1.0}, {2.0, {}}, {1.0, 0.0}};
  box.place = "s.yaml:4:12";
  scene.sand.initial = {box};
  const InitialState state = build_initial_state(scene);
  CHECK(state.depth == std::vector<double>{2, 0, 2, 0});
  CHECK(state.momentum_x == std::vector<double>{2, 0, 2, 0});
  CHECK(state.release.blocked_volume == 2.0);
  REQUIRE(state.warnings.size() == 1);
  CHECK(state.warnings[0] ==
        "s.yaml:4:12: sand.initial = box: 2 m^3 of 6 m^3 of sand lie where the terrain has no data and are left out "
        "(nodata: wall). Write \"nodata: nearest\", or make the part smaller.");

  for (const Fill& fill : {Fill{1.5, {}}, Fill{{}, 1.5}}) {
    scene.sand.initial = {SandLayer{fill}};
    CHECK(build_initial_state(scene).depth == std::vector<double>{1.5, 0, 1.5, 1.5});
    CHECK(build_initial_state(scene).release.blocked_volume == 0.0);
    CHECK(build_initial_state(scene).warnings.empty());
  }
}

TEST_CASE("a source on a wall is an error") {
  Scene scene = scene_of(4, 1, {0, nan, 0, 0}, Nodata::wall);
  scene.sand.sources = {SandSource{{1.0, 0.5}, 0.6, 1.0, 0.0, 1.0}};
  CHECK(test::initial_error(scene) ==
        "sand.sources: 1 of its 2 cells are walls, since the terrain has no data there. Move the source");
}

/// Keeps the depths of the last frame.
class LastDepth : public Sink {
 public:
  void begin(const Scene&, const StaticFields&) override {}
  void frame(Frame frame) override {
    const FieldValues& values = frame.fields.at(0).values;
    depth = std::visit([](const auto& v) { return std::vector<double>(v.begin(), v.end()); }, values);
  }
  void end(const FinalFields&) override {}
  std::vector<double> depth;
};

TEST_CASE("sand runs against a wall of NODATA as against the grid's edge, and none goes there") {
  // The same column in a box of 12 x 9 cells, and with two columns of NODATA beyond x_max.
  const auto make = [](int nx, Precision precision) {
    std::vector<double> bed;
    for (int j = 0; j < 9; ++j) {
      for (int i = 0; i < nx; ++i) {
        bed.push_back(i < 12 ? 1500.0 - 0.4 * i : nan);
      }
    }
    Scene scene = scene_of(nx, 9, bed, Nodata::wall);
    scene.numerics.precision = precision;
    scene.sand.friction_coefficient = 0.2;
    scene.sand.initial = {SandBox{{2.0, 2.0}, {6.0, 6.0}, {1.5, {}}}};
    scene.time.end = 60.0, scene.time.frame_interval = 1.0;
    return scene;
  };
  for (const Precision precision : {Precision::float64, Precision::float32}) {
    LastDepth at_edge, at_wall;
    const RunReport edge = run(make(12, precision), {}, at_edge);
    const RunReport wall = run(make(14, precision), {}, at_wall);
    REQUIRE(at_edge.depth.size() == 108);
    REQUIRE(at_wall.depth.size() == 126);
    double against_edge = 0.0, difference = 0.0;
    for (std::size_t j = 0; j < 9; ++j) {
      for (std::size_t i = 0; i < 14; ++i) {
        const double depth = at_wall.depth[j * 14 + i];
        if (i >= 12) {
          CHECK(depth == 0.0);
        } else {
          difference = std::max(difference, std::abs(depth - at_edge.depth[j * 12 + i]));
          against_edge = std::max(against_edge, i == 11 ? depth : 0.0);
        }
      }
    }
    CHECK(against_edge > 0.3);
    // Both reflect; the scheme reconstructs the cell at the edge with a mirrored neighbour, at the wall with a dry one.
    CHECK(difference < 0.1 * against_edge);
    CHECK_THAT(wall.ledger.final, WithinRel(24.0, 1e-6));
    INFO("against the edge " << against_edge << ", difference " << difference << ", violation "
                             << edge.max_slope_violation << " and " << wall.max_slope_violation);
    CHECK(edge.max_slope_violation < 0.01);
    CHECK(wall.max_slope_violation < 0.01);
  }
}

TEST_CASE("level sand beside walls stays at rest") {
  for (const Precision precision : {Precision::float64, Precision::float32}) {
    Scene scene = scene_of(4, 3, {0, 1, nan, 2, nan, 0.5, 0.25, nan, 1, nan, nan, 0}, Nodata::wall);
    scene.numerics.precision = precision;
    scene.sand.friction_coefficient = 0.0;
    scene.sand.initial = {SandLayer{{{}, 3.0}}};
    scene.time.end = 1.0, scene.time.frame_interval = 0.5;
    LastDepth last;
    run(scene, {}, last);
    CHECK(last.depth == build_initial_state(scene).depth);
  }
}

// ---- zones ----------------------------------------------------------------------------------------------------------

ZoneMap zones_of(std::vector<PolygonFeature> features, double elsewhere) {
  return {{"soils.gpkg", "", "phi", std::make_shared<PolygonLayer>(PolygonLayer{std::move(features)}), "s.yaml:3:40"},
          elsewhere};
}

TEST_CASE("cells take the mean of their zones by covered area") {
  Scene scene = scene_of(4, 1, {0, 0, 0, 0}, Nodata::error);
  scene.sand.friction_coefficient = zones_of(
      {{{{{0, 0}, {1.5, 0}, {1.5, 1}, {0, 1}}}, 0.2}, {{{{1.5, 0}, {2.75, 0}, {2.75, 1}, {1.5, 1}}}, 0.6}}, 1.0);
  const std::vector<double> mu = build_initial_state(scene).friction_coefficient;
  CHECK(mu[0] == 0.2);
  CHECK_THAT(mu[1], WithinRel(0.4, 1e-15));
  CHECK_THAT(mu[2], WithinRel(0.75 * 0.6 + 0.25, 1e-15));
  CHECK(mu[3] == 1.0);

  scene.sand.friction_coefficient.reset();
  scene.sand.friction_angle = zones_of({{{{{0, 0}, {0.5, 0}, {0.5, 1}, {0, 1}}}, 0.2}}, 0.6);
  CHECK_THAT(build_initial_state(scene).friction_coefficient[0], WithinRel(std::tan(0.4), 1e-15));
}

TEST_CASE("zones that overlap are an error with the cell") {
  Scene scene = scene_of(2, 1, {0, 0}, Nodata::error);
  const Ring cell{{1, 0}, {2, 0}, {2, 1}, {1, 1}};
  scene.sand.friction_coefficient = zones_of({{{cell}, 0.2}, {{cell}, 0.4}}, 1.0);
  CHECK(test::initial_error(scene) ==
        "s.yaml:3:40: sand.friction_coefficient = soils.gpkg: zones overlap: together they cover more than the whole "
        "cell "
        "in 1 of 2 cells, the first is cell (1, 0) at x = 1.5 m, y = 0.5 m with 2. Cut them so that each point lies in "
        "one");
}

TEST_CASE("a map of the material needs no data on walls") {
  Scene scene = scene_of(3, 1, {0, nan, 0}, Nodata::wall);
  const Raster mu{3, 1, 0.5, 0.5, 1.0, 1.0, true, {0.2, nan, 0.4}};
  scene.sand.friction_coefficient = RasterFile{"mu.asc", std::make_shared<const Raster>(mu)};
  CHECK(build_initial_state(scene).friction_coefficient == std::vector<double>{0.2, 0.4, 0.4});
}

}  // namespace
}  // namespace sandsim
