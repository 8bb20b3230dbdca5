// Writes the results that check_formats.py opens with h5py and xarray; hidden, since it needs a place to write to.
#include <cstdlib>

#include "io/output/series_writer.hpp"
#include "io/output/xdmf.hpp"
#include "tests/output/fixtures.hpp"
#include "tests/support/catch.hpp"

namespace sandsim::test {
namespace {

Scene scene_with_everything() {
  Scene scene = small_scene(6, 4);
  scene.output.fields = {OutputField::depth, OutputField::velocity, OutputField::surface, OutputField::momentum};
  scene.output.maxima.emplace();
  scene.output.probes = {{"left", {0.3, 0.3}}, {"r\u00e4nd", {1.3, 0.3}}};
  KinematicObject plate, ball;
  plate.name = "plate", ball.name = "b\u00e4ll";
  scene.objects = {plate, ball};
  scene.particles = Particles{};
  scene.particles->spacing = 0.5 * scene.grid.spacing;
  scene.reference.emplace();
  scene.reference->front_depths = {0.0, 0.125};
  scene.reference->exact = DamBreakReference{1.0, 0.2};
  return scene;
}

void write(const std::filesystem::path& path, const Scene& scene, bool finish) {
  SeriesWriter writer(settings_of(path));
  writer.begin(scene, {});
  for (std::int64_t index = 0; index < 3; ++index) writer.frame(frame_of(scene, index));
  if (finish) writer.end({map_of(scene, 1.0), map_of(scene, 2.0), map_of(scene, 3.0)});
}

}  // namespace

TEST_CASE("Results for other programs", "[.formats]") {
  const char* place = std::getenv("SANDSIM_FORMATS");
  REQUIRE(place != nullptr);
  const std::filesystem::path directory = place;
  Scene scene = scene_with_everything();

  write(directory / "float32.h5", scene, true);
  write_xdmf(directory / "float32.h5", directory / "float32.xdmf");
  write_particle_xdmf(directory / "float32.h5", directory / "particles.xdmf");
  scene.numerics.precision = Precision::float64;
  scene.output.compression = Compression::gzip;
  write(directory / "float64.h5", scene, true);
  write(directory / "killed.h5", scene, false);
  write_xdmf(directory / "killed.h5.partial", directory / "killed.xdmf");
}

}  // namespace sandsim::test
