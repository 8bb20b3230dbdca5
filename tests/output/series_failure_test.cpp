// What is left of a series when the run is killed or the disk is full.
#include <signal.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <fstream>
#include <thread>

#include "io/output/series_writer.hpp"
#include "solver/errors.hpp"
#include "tests/output/fixtures.hpp"
#include "tests/support/catch.hpp"

namespace sandsim::test {
namespace {

namespace fs = std::filesystem;

/// Writes frames until that fails; 6 (the exit code) if it failed with an OutputError that names a lack of space.
int write_until_full(const fs::path& path, const Scene& scene) {
  SeriesWriter writer(settings_of(path));
  try {
    writer.begin(scene, {});
    for (std::int64_t index = 0; index < 1000; ++index) writer.frame(frame_of(scene, index));
  } catch (const OutputError& error) {
    return std::string(error.what()).find("no space") != std::string::npos ? 6 : 97;
  }
  return 0;
}

void require_partial_is_intact(const fs::path& path, const Scene& scene) {
  std::int64_t frames = 0;
  CHECK_FALSE(fs::exists(path));
  CHECK(completed_frames_are_intact(partial_series_path(path), scene, frames));
  CHECK(frames > 0);
}

/// Appends to a series without end and without pause.
[[noreturn]] void write_for_ever(const fs::path& path, const Scene& scene) {
  SeriesWriter writer(settings_of(path));
  writer.begin(scene, {});
  for (std::int64_t index = 0;; ++index) writer.frame(frame_of(scene, index));
}

/// Resumes after one frame less than there are, writes a few more and ends.
void go_on(const fs::path& path, const Scene& scene, std::int64_t frames) {
  SeriesSettings settings = settings_of(path);
  settings.resume_frames = frames - 1;
  SeriesWriter writer(settings);
  writer.begin(scene, {});
  for (std::int64_t index = frames - 1; index < frames + 3; ++index) writer.frame(frame_of(scene, index));
  writer.end({});
  std::int64_t found = 0;
  CHECK(completed_frames_are_intact(path, scene, found));
  CHECK(found == frames + 3);
}

}  // namespace

TEST_CASE("The limit on the size of a file stops the run at the frame that does not fit") {
  const TemporaryDirectory directory;
  const Scene scene = small_scene(128, 128);

  const int code = run_in_child([&] {
    ::signal(SIGXFSZ, SIG_IGN);
    const struct rlimit limit { 12 << 20, 12 << 20 };
    ::setrlimit(RLIMIT_FSIZE, &limit);
    return write_until_full(directory / "series.h5", scene);
  });

  CHECK(code == 6);
  require_partial_is_intact(directory / "series.h5", scene);
}

TEST_CASE("A full disk stops the run at the frame that does not fit") {
  const TemporaryDirectory directory;
  if (::mount("tmpfs", directory.path().c_str(), "tmpfs", 0, "size=12m") != 0) {
    WARN("not tested: mounting a small file system is not permitted");
    return;
  }
  const Scene scene = small_scene(128, 128);

  CHECK(run_in_child([&] { return write_until_full(directory / "series.h5", scene); }) == 6);

  require_partial_is_intact(directory / "series.h5", scene);
  ::umount(directory.path().c_str());
}

TEST_CASE("A run that is killed leaves every frame that has a time and can be gone on with") {
  const TemporaryDirectory directory;
  const Scene scene = small_scene(64, 64);
  std::int64_t most = 0;
  // HDF5 writes a change of an index in several pieces. This writer does nothing but write: about one kill in 200 falls
  // between two of them and leaves an index that cannot be read or added to. That must be noticed.
  int damaged = 0;
  for (int attempt = 0; attempt < 12; ++attempt) {
    const fs::path path = directory / ("series-" + std::to_string(attempt) + ".h5");
    const pid_t child = ::fork();
    if (child == 0) write_for_ever(path, scene);
    std::this_thread::sleep_for(std::chrono::milliseconds(60) + std::chrono::microseconds(7919 * attempt));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    std::int64_t frames = 0;
    try {
      CHECK(completed_frames_are_intact(partial_series_path(path), scene, frames));
      if (frames > 0) go_on(path, scene, frames);
      most = std::max(most, frames);
    } catch (const std::exception&) {  // reading or going on says so
      ++damaged;
    }
  }
  CHECK(most > 0);
  CHECK(damaged <= 2);
}

TEST_CASE("A series that was damaged before its end does not get its final name") {
  const TemporaryDirectory directory;
  const Scene scene = small_scene(256, 256);
  SeriesWriter writer(settings_of(directory / "series.h5"));
  writer.begin(scene, {});
  writer.frame(frame_of(scene, 0));
  const fs::path partial = directory / "series.h5.partial";
  // A lost write would look like this.
  const Frame frame = frame_of(scene, 0);
  const auto& values = std::get<std::vector<float>>(frame.fields.back().values);
  const std::string bytes = read_text(partial);
  const std::size_t at = bytes.find(std::string(reinterpret_cast<const char*>(values.data()), 4096));
  REQUIRE(at != std::string::npos);
  std::fstream(partial, std::ios::binary | std::ios::in | std::ios::out).seekp(static_cast<std::streamoff>(at))
      << std::string(4096, '\0');

  const std::string message = message_of<OutputError>([&] { writer.end({}); });

  CHECK(message.find("reads differently") != std::string::npos);
  CHECK_FALSE(fs::exists(directory / "series.h5"));
}

}  // namespace sandsim::test
