// Small scenes and frames whose every value is known.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "io/output/series_writer.hpp"
#include "solver/scene.hpp"
#include "solver/sink.hpp"

namespace sandsim::test {

/// A directory of its own that is removed at the end of the test.
class TemporaryDirectory {
 public:
  TemporaryDirectory();
  ~TemporaryDirectory();
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

/// nx * ny cells of 0.5 m, flat, depth and velocity, float32.
Scene small_scene(int nx, int ny);

/// The value of a field in a cell: different for every field, frame and cell, and exact in float32.
double field_value(const std::string& name, std::int64_t frame, std::size_t cell);

/// A frame with the scene's fields and probes, at 0.25 s times its index.
Frame frame_of(const Scene& scene, std::int64_t index);

FieldValues map_of(const Scene& scene, double first);

SeriesSettings settings_of(const std::filesystem::path& path);

/// Writes a finished series of so many frames.
void write_series(const std::filesystem::path& path, const Scene& scene, std::int64_t frames);

/// True if the frames that have a time are all there, in order, with the values of frame_of().
bool completed_frames_are_intact(const std::filesystem::path& path, const Scene& scene, std::int64_t& frames);

/// Runs `work` in a child process, which may be harmed; returns its exit code, or 128 and the signal that ended it.
int run_in_child(const std::function<int()>& work);

std::string read_text(const std::filesystem::path& path);
void write_text(const std::filesystem::path& path, const std::string& text);

/// The message of the Error that `work` throws; fails the test if it throws another type.
template <class ExpectedError>
std::string message_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const ExpectedError& error) {
    return error.what();
  }
  return "nothing was thrown";
}

}  // namespace sandsim::test
