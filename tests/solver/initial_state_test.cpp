#include "solver/initial_state.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <string>

#include "tests/solver/support.hpp"
#include "tests/support/catch.hpp"

namespace sandsim {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double pi = std::numbers::pi;

Scene scene_of(int nx, int ny, double spacing = 1.0) {
  Scene scene;
  scene.grid = {{nx, ny}, spacing, {0.0, 0.0}};
  scene.sand.friction_coefficient = 0.5;
  scene.numerics.precision = Precision::float64;
  return scene;
}

/// A raster that lies on the cells of the grid.
RasterFile raster_file(std::size_t nx, std::size_t ny, std::vector<double> values, bool has_georeference = true) {
  return {"a.asc",
          std::make_shared<const Raster>(Raster{nx, ny, 0.5, 0.5, 1.0, 1.0, has_georeference, std::move(values)})};
}

Fill depth(double value) {
  return {value, {}};
}
Fill surface(double value) {
  return {{}, value};
}

std::vector<double> depth_of(const Scene& scene) {
  return build_initial_state(scene).depth;
}
double volume(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

TEST_CASE("sand at rest has no momentum") {
  Scene scene = scene_of(2, 2);
  scene.sand.initial = {SandLayer{depth(1.0)}};
  CHECK(build_initial_state(scene).momentum_x.empty());
  CHECK(build_initial_state(scene).momentum_y.empty());
}

TEST_CASE("each part of the sand brings the momentum of its own depth along") {
  Scene scene = scene_of(3, 2);
  scene.sand.initial = {SandLayer{depth(2.0)}, SandBox{{0.0, 0.0}, {1.5, 1.0}, depth(4.0), {10.0, -1.0}},
                        SandLayer{surface(3.0), {0.0, 0.5}}};
  const InitialState state = build_initial_state(scene);
  CHECK(state.depth == std::vector<double>{6, 4, 3, 3, 3, 3});
  CHECK(state.momentum_x == std::vector<double>{40, 20, 0, 0, 0, 0});
  CHECK(state.momentum_y == std::vector<double>{-4, -2, 0.5, 0.5, 0.5, 0.5});
}

TEST_CASE("a solid object takes the momentum of the sand that it replaces") {
  Scene scene = scene_of(2, 1);
  scene.sand.initial = {SandLayer{depth(1.0), {3.0, 0.0}}};
  KinematicObject block;
  block.shape = BoxShape{{1.0, 1.0, 4.0}, {}};
  block.position = {0.5, 0.5, 0.0};
  block.coupling = Coupling::solid;
  scene.objects = {block};
  const InitialState state = build_initial_state(scene);
  CHECK(state.depth == std::vector<double>{0, 1});
  CHECK(state.momentum_x == std::vector<double>{0, 3});
}

TEST_CASE("flat terrain at level zero has no bed") {
  Scene scene = scene_of(3, 1);
  CHECK(build_initial_state(scene).bed.empty());
  scene.terrain = {FlatTerrain{}, FlatTerrain{}};
  CHECK(build_initial_state(scene).bed.empty());
  scene.terrain = {FlatTerrain{2.0}};
  CHECK(build_initial_state(scene).bed == std::vector<double>{2, 2, 2});
}

TEST_CASE("a plane falls along its direction from the grid's origin") {
  Scene scene = scene_of(2, 2);
  scene.grid.origin = {100.0, 50.0};
  const double slope = std::tan(0.3);

  scene.terrain = {PlaneTerrain{0.3, 0.0, 1.0}};
  CHECK(build_initial_state(scene).bed ==
        std::vector<double>{1 - 0.5 * slope, 1 - 1.5 * slope, 1 - 0.5 * slope, 1 - 1.5 * slope});
  scene.terrain = {PlaneTerrain{0.3, pi, 1.0}};
  CHECK(build_initial_state(scene).bed[1] == 1 + 1.5 * slope);
}

TEST_CASE("the bed is what the run's precision holds and sand fills it up to its level") {
  Scene scene = scene_of(64, 1, 0.01);
  scene.numerics.precision = Precision::float32;
  scene.terrain = {PlaneTerrain{1.2, 0.0, 10.0}};
  scene.sand.initial = {SandLayer{surface(10.0)}};
  const InitialState state = build_initial_state(scene);
  for (std::size_t cell = 0; cell < 64; ++cell) {
    CHECK(state.bed[cell] == static_cast<double>(static_cast<float>(state.bed[cell])));
    // The sum rounds once in double precision; a bed that is rounded afterwards would be off by 5e-7.
    CHECK_THAT(state.bed[cell] + state.depth[cell], WithinAbs(10.0, 4e-15));
  }
}

TEST_CASE("planes in transposed directions are transposed to the last bit") {
  Scene scene = scene_of(5, 5, 0.1);
  scene.terrain = {PlaneTerrain{0.3, 0.0, 0.0}};
  const std::vector<double> along_x = build_initial_state(scene).bed;
  scene.terrain = {PlaneTerrain{0.3, 0.5 * pi, 0.0}};
  const std::vector<double> along_y = build_initial_state(scene).bed;
  scene.terrain = {PlaneTerrain{0.3, 0.25 * pi, 0.0}};
  const std::vector<double> diagonal = build_initial_state(scene).bed;

  for (std::size_t j = 0; j < 5; ++j) {
    for (std::size_t i = 0; i < 5; ++i) {
      CHECK(along_y[i * 5 + j] == along_x[j * 5 + i]);
      CHECK(diagonal[i * 5 + j] == diagonal[j * 5 + i]);
    }
  }
}

TEST_CASE("terrain parts add up and rasters are scaled and shifted") {
  Scene scene = scene_of(2, 1);
  scene.terrain = {FlatTerrain{10.0}, RasterTerrain{raster_file(2, 1, {3, 4}), 2.0, 0.5},
                   RasterTerrain{raster_file(2, 1, {1, 2}, false)}};

  CHECK(build_initial_state(scene).bed == std::vector<double>{17.5, 20.5});
}

TEST_CASE("a box fills cells by the part that it covers") {
  Scene scene = scene_of(4, 3);
  scene.sand.initial = {SandBox{{0.5, 1.0}, {3.0, 1.25}, depth(2.0)}};

  CHECK(depth_of(scene) == std::vector<double>{0, 0, 0, 0, 0.25, 0.5, 0.5, 0, 0, 0, 0, 0});
}

TEST_CASE("a box in a scene of one row covers it whatever its y") {
  Scene scene = scene_of(4, 1);
  scene.sand.initial = {SandBox{{0.0, 7.0}, {1.5, 8.0}, depth(2.0)}};

  CHECK(depth_of(scene) == std::vector<double>{2, 1, 0, 0});
}

TEST_CASE("a box with edges on faces leaves no slivers for any spacing") {
  for (const double spacing : {0.1, 0.01, 0.07, 1.0 / 3.0}) {
    for (int edge = 1; edge < 200; ++edge) {
      Scene scene = scene_of(200, 1, spacing);
      scene.sand.initial = {SandBox{{spacing * edge, 0}, {200 * spacing, 1}, depth(0.3)}};
      const std::vector<double> depths = depth_of(scene);
      CHECK(depths[edge - 1] == 0.0);
      CHECK(depths[edge] == 0.3);
      CHECK(depths[199] == 0.3);
    }
  }
}

TEST_CASE("a column covers cells symmetrically and has its area") {
  Scene scene = scene_of(40, 40, 0.05);
  scene.sand.initial = {SandColumn{{1.0, 1.0}, 0.63, depth(1.0)}};

  const std::vector<double> depths = depth_of(scene);

  // The radius is rounded to 2^-30 of a cell.
  CHECK_THAT(volume(depths) * 0.05 * 0.05, WithinRel(pi * 0.63 * 0.63, 1e-9));
  for (std::size_t j = 0; j < 40; ++j) {
    for (std::size_t i = 0; i < 40; ++i) {
      CHECK(depths[j * 40 + i] == depths[j * 40 + 39 - i]);
      CHECK(depths[j * 40 + i] == depths[i * 40 + j]);
    }
  }
}

TEST_CASE("a column smaller than a cell has its area too") {
  Scene scene = scene_of(1, 3);
  scene.sand.initial = {SandColumn{{0.5, 1.5}, 0.25, depth(1.0)}};

  const std::vector<double> depths = depth_of(scene);
  CHECK(depths[0] == 0.0);
  CHECK_THAT(depths[1], WithinRel(pi / 16.0, 1e-15));
  CHECK(depths[2] == 0.0);
}

TEST_CASE("a column in a scene of one row covers a length on both sides alike") {
  Scene scene = scene_of(6, 1, 0.1);
  scene.sand.initial = {SandColumn{{0.3, 9.0}, 0.125, depth(1.0)}};

  const std::vector<double> depths = depth_of(scene);

  CHECK(depths[0] == 0.0);
  CHECK_THAT(depths[1], WithinAbs(0.25, 1e-9));  // edges are rounded to 2^-30 of a cell
  CHECK(depths[2] == 1.0);
  CHECK(depths[3] == 1.0);
  CHECK(depths[4] == depths[1]);
  CHECK(depths[5] == 0.0);
}

TEST_CASE("a cone has its mean depth in every cell, its volume, and ends at its radius") {
  Scene scene = scene_of(5, 5);
  scene.sand.initial = {SandCone{{2.5, 2.5}, 2.0, 4.0}};

  const std::vector<double> depths = depth_of(scene);

  // The mean distance from the centre of a unit square is (sqrt 2 + asinh 1) / 6.
  CHECK_THAT(depths[2 * 5 + 2], WithinRel(4.0 - 2.0 * (std::numbers::sqrt2 + std::asinh(1.0)) / 6.0, 1e-14));
  CHECK(depths[2 * 5 + 4] > 0.0);
  CHECK(depths[1 * 5 + 2] == depths[2 * 5 + 3]);
  CHECK(depths[0] == 0.0);
  CHECK_THAT(volume(depths), WithinRel(pi * 4.0 * 4.0 / 3.0, 1e-13));
}

TEST_CASE("a cone in a scene of one row depends on x alone") {
  Scene scene = scene_of(3, 1);
  scene.sand.initial = {SandCone{{1.5, 40.0}, 2.0, 4.0}};

  CHECK(depth_of(scene) == std::vector<double>{2, 3.5, 2});  // the means over the cells
}

TEST_CASE("a level fills what the bed and the sand before it leave") {
  Scene scene = scene_of(4, 1);
  scene.terrain = {RasterTerrain{raster_file(4, 1, {0, 1, 2, 5})}};
  scene.sand.initial = {SandBox{{0, 0}, {1, 1}, depth(2.5)}, SandLayer{surface(3.0)},
                        SandBox{{0, 0}, {0.5, 1}, surface(4.0)}};

  CHECK(depth_of(scene) == std::vector<double>{3.5, 2, 1, 0});
}

TEST_CASE("sand parts add up and a depth raster without data means no sand") {
  Scene scene = scene_of(3, 1);
  scene.sand.initial = {SandLayer{depth(1.0)}, SandRaster{raster_file(3, 1, {nan, 2, 3}, false), 2.0},
                        SandRaster{raster_file(2, 1, {10, 20})}};

  CHECK(depth_of(scene) == std::vector<double>{11, 25, 7});
}

TEST_CASE("no sand at all is a depth of zero") {
  CHECK(depth_of(scene_of(2, 1)) == std::vector<double>{0, 0});
}

TEST_CASE("friction is a coefficient or the tangent of an angle") {
  Scene scene = scene_of(2, 1);
  CHECK(build_initial_state(scene).friction_coefficient == std::vector<double>{0.5});

  scene.sand.friction_coefficient.reset();
  scene.sand.friction_angle = 0.25 * pi;
  CHECK(build_initial_state(scene).friction_coefficient == std::vector<double>{std::tan(0.25 * pi)});

  scene.sand.friction_angle = raster_file(2, 1, {0.0, 0.5});
  CHECK(build_initial_state(scene).friction_coefficient == std::vector<double>{0.0, std::tan(0.5)});
}

TEST_CASE("every hbar policy has its scale and cap") {
  Scene scene = scene_of(2, 1);
  const auto check = [&](const Hbar& hbar, std::vector<double> scale, std::vector<double> cap) {
    scene.sand.hbar = hbar;
    const InitialState state = build_initial_state(scene);
    CHECK(state.hbar_scale == scale);
    CHECK(state.hbar_cap == cap);
  };

  check({HbarPolicy::full, 0.0, 1.0, 0.0}, {1.0}, {1e30});
  check({HbarPolicy::constant, 0.05, 1.0, 0.0}, {1.0}, {0.05});
  check({HbarPolicy::scaled, 0.0, 0.8, 0.0}, {0.8}, {1e30});
  check({HbarPolicy::truncated, 0.0, 0.8, 0.05}, {0.8}, {0.05});
  check({HbarPolicy::truncated, 0.0, raster_file(2, 1, {0.5, 1.0}), raster_file(2, 1, {3, 4}, false)}, {0.5, 1.0},
        {3, 4});
}

TEST_CASE("a raster without position and of another size is an error naming both sizes") {
  const std::string rest =
      " = a.asc: the raster has 2 x 1 values, the grid 3 x 1 cells (a file that carries no position must have the "
      "grid's size). Use an ESRI ASCII grid, which is resampled, or change grid.cells";
  const RasterFile file = raster_file(2, 1, {1, 2}, false);
  Scene scene = scene_of(3, 1);
  scene.terrain = {RasterTerrain{file}};
  scene.sand.initial = {SandRaster{file}};
  scene.sand.friction_coefficient = file;

  CHECK(test::initial_error(scene) ==
        "terrain.file" + rest + "\nsand.initial.file" + rest + "\nsand.friction_coefficient" + rest);
}

TEST_CASE("a bed that is not finite is an error") {
  Scene scene = scene_of(1, 1);
  scene.terrain = {RasterTerrain{raster_file(1, 1, {1e300}), 1e300, 0.0}};

  CHECK(test::initial_error(scene) ==
        "terrain: the bed is not finite in 1 of 1 cells, the first is cell (0, 0) at x = 0.5 m, y = 0.5 m with inf");
}

TEST_CASE("negative depths are errors") {
  Scene scene = scene_of(2, 1);
  scene.sand.initial = {SandLayer{depth(5.0)}, SandRaster{raster_file(2, 1, {1, -1})}};
  CHECK(test::initial_error(scene) ==
        "sand.initial.1.file = a.asc: the raster has negative depths in 1 of 2 cells, the first is cell (1, 0) at x = "
        "1.5 m, y = 0.5 m with -1");

  scene.sand.initial = {SandLayer{depth(-5.0)}};
  CHECK(test::initial_error(scene) ==
        "sand.initial: the depth is negative or not finite in 2 of 2 cells, the first is cell (0, 0) at x = 0.5 m, y = "
        "0.5 m with -5");
}

TEST_CASE("material outside its range is an error") {
  Scene scene = scene_of(2, 1);
  scene.sand.friction_coefficient = -0.1;
  CHECK(test::initial_error(scene) ==
        "sand.friction_coefficient = -0.1: the friction coefficient is negative or not finite");

  scene.sand.friction_coefficient.reset();
  CHECK(test::initial_error(scene) == "sand: exactly one of friction_angle and friction_coefficient must be given");
  scene.sand.friction_angle = raster_file(2, 1, {0.5, 30.0});
  CHECK(test::initial_error(scene) ==
        "sand.friction_angle = a.asc: the friction angle is not in [0, pi/2) rad in 1 "
        "of 2 cells, the first is cell (1, 0) at x = 1.5 m, y = 0.5 m with 30");
  scene.sand.friction_angle = raster_file(1, 1, {0.5});
  CHECK(test::initial_error(scene) ==
        "sand.friction_angle = a.asc: the raster has no data (outside its edges, or NODATA) in 1 of 2 cells, the first "
        "is cell (1, 0) at x = 1.5 m, y = 0.5 m with nan");
}

TEST_CASE("hbar outside its range is an error") {
  Scene scene = scene_of(2, 1);
  scene.sand.hbar = {HbarPolicy::truncated, 0.0, 1.5, -1.0};
  CHECK(test::initial_error(scene) ==
        "sand.hbar.scale = 1.5: the scale of hbar is not in (0, 1]\n"
        "sand.hbar.cap = -1: the cap of hbar is not positive and finite [m]");
  scene.sand.hbar = {HbarPolicy::constant, 0.0, 1.0, 0.0};
  CHECK(test::initial_error(scene) == "sand.hbar.depth = 0: the cap of hbar is not positive and finite [m]");
  scene.sand.hbar = {HbarPolicy::scaled, 0.0, raster_file(2, 1, {0.5, 0.0}), 0.0};
  CHECK(test::initial_error(scene) ==
        "sand.hbar.scale = a.asc: the scale of hbar is not in (0, 1] in 1 of 2 cells, the first is cell (1, 0) at x = "
        "1.5 m, y = 0.5 m with 0");
}

}  // namespace
}  // namespace sandsim
