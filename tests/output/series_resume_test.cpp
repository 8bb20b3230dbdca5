#include "io/hdf5/hdf5.hpp"
#include "io/output/series_reader.hpp"
#include "io/output/series_writer.hpp"
#include "solver/errors.hpp"
#include "tests/output/fixtures.hpp"
#include "tests/support/catch.hpp"

namespace sandsim::test {
namespace {

namespace fs = std::filesystem;

void write_partial(const fs::path& path, const Scene& scene, std::int64_t frames) {
  SeriesWriter writer(settings_of(path));
  writer.begin(scene, {});
  for (std::int64_t index = 0; index < frames; ++index) writer.frame(frame_of(scene, index));
}

SeriesSettings resume_settings(const fs::path& path, std::int64_t frames) {
  SeriesSettings settings = settings_of(path);
  settings.resume_frames = frames;
  return settings;
}

void resume(const fs::path& path, const Scene& scene, std::int64_t from, std::int64_t to) {
  SeriesWriter writer(resume_settings(path, from));
  writer.begin(scene, {});
  for (std::int64_t index = from; index < to; ++index) writer.frame(frame_of(scene, index));
  writer.end({});
}

}  // namespace

TEST_CASE("A partial series is cut to the checkpoint and goes on from there") {
  const TemporaryDirectory directory;
  const Scene scene = small_scene(300, 4);
  const auto from = GENERATE(0, 1, 3);
  write_partial(directory / "series.h5", scene, 3);

  resume(directory / "series.h5", scene, from, 5);

  std::int64_t frames = 0;
  CHECK(completed_frames_are_intact(directory / "series.h5", scene, frames));
  CHECK(frames == 5);
  CHECK_FALSE(fs::exists(directory / "series.h5.partial"));
}

TEST_CASE("A finished series can be gone on with") {
  const TemporaryDirectory directory;
  const Scene scene = small_scene(6, 4);
  write_series(directory / "series.h5", scene, 4);

  resume(directory / "series.h5", scene, 2, 600);

  std::int64_t frames = 0;
  CHECK(completed_frames_are_intact(directory / "series.h5", scene, frames));
  CHECK(frames == 600);
  const hdf5::Session session;
  CHECK(SeriesReader(directory / "series.h5").attribute("history").find("resumed") != std::string::npos);
}

TEST_CASE("What cannot be gone on with is an input error that says why") {
  const TemporaryDirectory directory;
  const Scene scene = small_scene(6, 4);
  Scene other = scene;
  std::string reason;
  std::int64_t frames = 2;
  write_partial(directory / "series.h5", scene, 2);

  SECTION("more frames than there are") {
    frames = 3;
    reason = "holds 2 frames";
  }
  SECTION("another grid") {
    other.grid.cells = {6, 5};
    reason = "4 values where the scene has 5";
  }
  SECTION("another precision") {
    other.numerics.precision = Precision::float64;
    reason = "of another precision";
  }
  SECTION("other fields") {
    other.output.fields.push_back(OutputField::surface);
    reason = "no surface";
  }
  SECTION("not an HDF5 file") {
    write_text(directory / "series.h5.partial", "nothing of the kind");
    reason = "could not open the file";
  }
  SECTION("no file") {
    fs::remove(directory / "series.h5.partial");
    reason = "neither it nor series.h5.partial";
  }

  SeriesWriter writer(resume_settings(directory / "series.h5", frames));
  const std::string message = message_of<InputError>([&] { writer.begin(other, {}); });
  CHECK(message.find(reason) != std::string::npos);
  INFO(message);
}

}  // namespace sandsim::test
