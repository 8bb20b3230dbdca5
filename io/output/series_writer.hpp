// Writes series.h5: HDF5 that is also valid NetCDF-4 with CF conventions.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "solver/sink.hpp"

namespace sandsim {

/// What the file says about the run besides its data.
struct SeriesSettings {
  std::filesystem::path path;                 // of the finished file, e.g. DIR/series.h5
  std::string resolved_scene;                 // YAML, becomes the attribute `scene`
  std::string device;                         // e.g. "cpu", becomes the attribute `device`
  std::string history;                        // e.g. the command line; a time stamp is put before it
  std::optional<std::int64_t> resume_frames;  // go on after so many frames of a file that is there
};

/// The file under which frames are collected until the run is over: `path` with ".partial" behind it.
std::filesystem::path partial_series_path(const std::filesystem::path& path);

class SeriesFile;

/// Writes PATH.partial, flushed after every frame, and renames it to PATH at the end, once it has been read back.
/// `time` is written last: a frame without a time was not completed. The variables and their units are listed in
/// series_layout.hpp. On failure the partial file stays, and can be read up to its last frame.
/// All functions throw OutputError; begin() throws InputError where there is nothing to resume.
class SeriesWriter : public Sink {
 public:
  explicit SeriesWriter(SeriesSettings settings);
  ~SeriesWriter() override;
  SeriesWriter(const SeriesWriter&) = delete;
  SeriesWriter& operator=(const SeriesWriter&) = delete;

  void begin(const Scene& scene, const StaticFields& fields) override;
  void frame(Frame frame) override;
  void end(const FinalFields& fields) override;

 private:
  SeriesSettings settings_;
  std::unique_ptr<SeriesFile> file_;
};

}  // namespace sandsim
