#include "io/output/series_writer.hpp"

#include <cmath>
#include <limits>

#include "io/hdf5/hdf5.hpp"
#include "io/output/series_reader.hpp"
#include "solver/errors.hpp"
#include "tests/output/fixtures.hpp"
#include "tests/support/catch.hpp"

namespace sandsim::test {
namespace {

namespace fs = std::filesystem;
using Strings = std::vector<std::string>;

std::vector<double> read(const fs::path& path, const std::string& name) {
  const hdf5::Session session;
  return hdf5::read_all<double>(hdf5::open_file(path, false).id(), name);
}

hsize_t stored_bytes(const fs::path& path, const std::string& name) {
  const hdf5::Session session;
  const hdf5::Handle file = hdf5::open_file(path, false);
  return H5Dget_storage_size(hdf5::open_dataset(file.id(), name).id());
}

bool holds(const fs::path& path, const std::string& name) {
  const hdf5::Session session;
  return hdf5::exists(hdf5::open_file(path, false).id(), name);
}

}  // namespace

TEST_CASE("A finished series holds every frame as it was written") {
  const TemporaryDirectory directory;
  const Precision precision = GENERATE(Precision::float32, Precision::float64);
  const Compression compression = GENERATE(Compression::none, Compression::gzip);
  // One cell, one row, one column, and more than one chunk along both directions.
  const auto cells = GENERATE(std::array{1, 1}, std::array{7, 1}, std::array{1, 5}, std::array{300, 260});
  Scene scene = small_scene(cells[0], cells[1]);
  scene.numerics.precision = precision;
  scene.output.compression = compression;
  scene.output.fields = {OutputField::depth, OutputField::velocity, OutputField::surface, OutputField::momentum};

  write_series(directory / "series.h5", scene, 3);

  std::int64_t frames = 0;
  CHECK(completed_frames_are_intact(directory / "series.h5", scene, frames));
  CHECK(frames == 3);
  CHECK_FALSE(fs::exists(directory / "series.h5.partial"));
}

TEST_CASE("A series has the dimensions and units of the interface") {
  const TemporaryDirectory directory;
  write_series(directory / "series.h5", small_scene(4, 3), 2);

  const hdf5::Session session;
  const SeriesReader series(directory / "series.h5");
  REQUIRE(series.find("depth") != nullptr);
  CHECK(series.find("depth")->dimensions == Strings{"time", "y", "x"});
  CHECK(series.find("depth")->extent == std::vector<hsize_t>{2, 3, 4});
  CHECK(series.find("depth")->units == "m");
  CHECK(series.find("depth")->element_size == 4);
  CHECK(series.find("velocity_x")->units == "m/s");
  CHECK(series.find("bed")->dimensions == Strings{"y", "x"});
  CHECK(series.find("volume")->units == "m^3");
  CHECK(series.read_coordinate("x") == std::vector<double>{0.25, 0.75, 1.25, 1.75});
  CHECK(series.read_coordinate("y") == std::vector<double>{0.25, 0.75, 1.25});
  CHECK(series.read_coordinate("max_speed") == std::vector<double>{0.5, 0.5});
  CHECK(series.attribute("Conventions") == "CF-1.10");
  CHECK(series.attribute("title") == "A small scene");
  CHECK(series.attribute("scene") == "title: A small scene\n");
  CHECK(series.attribute("device") == "cpu");
  CHECK(series.attribute("source").starts_with("sandsim "));
  CHECK(series.attribute("history").ends_with(" sandsim run"));
}

TEST_CASE("A flat bed takes no space and reads as zero") {
  const TemporaryDirectory directory;
  write_series(directory / "series.h5", small_scene(4, 3), 1);

  CHECK(stored_bytes(directory / "series.h5", "bed") == 0);
  CHECK(read(directory / "series.h5", "bed") == std::vector<double>(12, 0.0));
}

TEST_CASE("Bed and maxima are written as maps") {
  const TemporaryDirectory directory;
  Scene scene = small_scene(4, 3);
  scene.output.maxima = MaximaOutput{0.01, true};
  scene.sand.density = 1500.0;
  FinalFields maxima{map_of(scene, 1.0), map_of(scene, 2.0), map_of(scene, 3.0)};
  std::get<std::vector<float>>(maxima.arrival_time)[5] = std::numeric_limits<float>::quiet_NaN();

  SeriesWriter writer(settings_of(directory / "series.h5"));
  writer.begin(scene, {map_of(scene, 7.0)});
  writer.frame(frame_of(scene, 0));
  writer.end(maxima);

  CHECK(read(directory / "series.h5", "bed")[11] == 18.0);
  CHECK(read(directory / "series.h5", "max_depth")[11] == 12.0);
  CHECK(read(directory / "series.h5", "max_speed_over_time")[11] == 13.0);
  CHECK(read(directory / "series.h5", "arrival_time")[11] == 14.0);
  CHECK(std::isnan(read(directory / "series.h5", "arrival_time")[5]));
  CHECK(read(directory / "series.h5", "max_pressure")[11] == 1500.0 * 13.0 * 13.0);
  CHECK(read(directory / "series.h5", "max_speed").size() == 1);
}

TEST_CASE("Without frames the series keeps the numbers and probes alone") {
  const TemporaryDirectory directory;
  Scene scene = small_scene(4, 3);
  scene.output.frames = false;
  scene.output.probes = {{"gauge", {0.3, 0.3}}};

  write_series(directory / "series.h5", scene, 4);

  CHECK_FALSE(holds(directory / "series.h5", "depth"));
  CHECK_FALSE(holds(directory / "series.h5", "bed"));
  CHECK(read(directory / "series.h5", "volume") == std::vector<double>{10.0, 11.0, 12.0, 13.0});
  CHECK(read(directory / "series.h5", "probe_depth") == std::vector<double>{0.0, 1.0, 2.0, 3.0});
}

TEST_CASE("Probes fronts and the exact solution go over time") {
  const TemporaryDirectory directory;
  Scene scene = small_scene(4, 1);
  scene.output.probes = {{"left", {0.3, 0.3}}, {"r\u00e4nd", {1.3, 0.3}}};
  scene.reference.emplace();
  scene.reference->front_depths = {0.0, 0.125};
  scene.reference->exact = DamBreakReference{1.0, 0.2};

  SeriesWriter writer(settings_of(directory / "series.h5"));
  writer.begin(scene, {});
  for (std::int64_t index = 0; index < 3; ++index) {
    Frame frame = frame_of(scene, index);
    frame.reference_tip = 5.0;
    if (index == 1) frame.reference_depth = {4.0, 3.0, 2.0, 1.0};
    writer.frame(std::move(frame));
  }
  writer.end({});

  const fs::path path = directory / "series.h5";
  CHECK(read(path, "probe_depth") == std::vector<double>{0.0, 0.5, 1.0, 1.5, 2.0, 2.5});
  CHECK(read(path, "probe_x") == std::vector<double>{0.3, 1.3});
  CHECK(read(path, "front") == std::vector<double>{0.0, 0.125, 1.0, 1.125, 2.0, 2.125});
  CHECK(read(path, "reference_tip") == std::vector<double>{5.0, 5.0, 5.0});
  const std::vector<double> exact = read(path, "reference_depth");
  CHECK(std::isnan(exact[0]));
  CHECK(exact[4] == 4.0);
  CHECK(exact[7] == 1.0);
  CHECK(std::isnan(exact[8]));
}

TEST_CASE("A scene text of more than 64 KB fits into its attribute") {
  const TemporaryDirectory directory;
  const Scene scene = small_scene(2, 1);
  SeriesSettings settings = settings_of(directory / "series.h5");
  settings.resolved_scene = std::string(200000, 'x');

  SeriesWriter writer(settings);
  writer.begin(scene, {});
  writer.end({});

  const hdf5::Session session;
  CHECK(SeriesReader(directory / "series.h5").attribute("scene") == settings.resolved_scene);
}

TEST_CASE("A series that is not ended stays partial and keeps its frames") {
  const TemporaryDirectory directory;
  const Scene scene = small_scene(5, 3);
  {
    SeriesWriter writer(settings_of(directory / "series.h5"));
    writer.begin(scene, {});
    writer.frame(frame_of(scene, 0));
    writer.frame(frame_of(scene, 1));
  }
  std::int64_t frames = 0;
  CHECK_FALSE(fs::exists(directory / "series.h5"));
  CHECK(completed_frames_are_intact(directory / "series.h5.partial", scene, frames));
  CHECK(frames == 2);
}

TEST_CASE("Frames that do not fit the scene are refused") {
  const TemporaryDirectory directory;
  const Scene scene = small_scene(5, 3);
  SeriesWriter writer(settings_of(directory / "series.h5"));
  writer.begin(scene, {});
  Frame frame = frame_of(scene, 0);

  SECTION("out of order") {
    frame.index = 3;
  }
  SECTION("a field is missing") {
    frame.fields.pop_back();
  }
  SECTION("an unknown field") {
    frame.fields.back().name = "temperature";
  }
  SECTION("a field of another size") {
    frame.fields[0].values = std::vector<float>(14);
  }
  SECTION("a probe that the scene does not have") {
    frame.probes.resize(1);
  }
  SECTION("a front that the scene does not have") {
    frame.fronts.resize(1);
  }

  CHECK_THROWS_AS(writer.frame(std::move(frame)), OutputError);
  // What came before stays as it is, so nothing may follow.
  CHECK_THROWS_AS(writer.frame(frame_of(scene, 0)), OutputError);
  CHECK_THROWS_AS(writer.end({}), OutputError);
}

TEST_CASE("A series in a directory that is not there is an output error") {
  const TemporaryDirectory directory;
  SeriesWriter writer(settings_of(directory / "missing/series.h5"));

  const std::string message = message_of<OutputError>([&] { writer.begin(small_scene(2, 2), {}); });

  CHECK(message.find("missing/series.h5.partial") != std::string::npos);
  CHECK(message.find("No such file or directory") != std::string::npos);
}

}  // namespace sandsim::test
