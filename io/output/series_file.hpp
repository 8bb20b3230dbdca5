// An open series.h5, as the writer and nobody else sees it. Internal to io/output.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/hdf5/hdf5.hpp"
#include "io/output/disk_space.hpp"
#include "io/output/file_reserve.hpp"
#include "io/output/series_layout.hpp"
#include "io/output/series_writer.hpp"

namespace sandsim {

/// A variable of the layout and its open data set.
struct OpenVariable {
  Variable variable;
  hdf5::Handle dataset;
};

/// The caller holds an hdf5::Session during every call and turns hdf5::Failure into its own error.
class SeriesFile {
 public:
  /// A new file with all its variables and attributes, and no frames.
  static SeriesFile create(const std::filesystem::path& path, const Scene& scene, const SeriesSettings& settings);
  /// A file that is there, cut to `frames` frames. Throws InputError if it is not of this scene's shape.
  static SeriesFile reopen(const std::filesystem::path& path, const Scene& scene, const SeriesSettings& settings,
                           std::int64_t frames);

  void write_bed(const FieldValues& bed);
  /// Writes everything of the frame, flushes, then writes its time and flushes again.
  void append(Frame frame);
  void write_maxima(const FinalFields& fields);
  /// Flushes, syncs and closes; errors that a destructor would hide are thrown.
  void close();

  /// Opens the closed file again and compares: frames, shapes, the chunks on the disk and the last frame bit for bit.
  /// Throws OutputError.
  void verify() const;

 private:
  SeriesFile(const std::filesystem::path& path, const Scene& scene, hdf5::Handle file);

  const OpenVariable& find(const std::string& name) const;
  void write_map(const std::string& name, const FieldValues& values);
  void check(const Frame& frame) const;
  void extend(const OpenVariable& open, hsize_t frames) const;
  void write_values(const std::string& name, const FieldValues& values) const;
  void write_number(const std::string& name, double value) const;
  void write_count(const std::string& name, std::int64_t value) const;
  void write_row(const std::string& name, const std::vector<double>& values) const;
  void write_statistics(const FrameStatistics& statistics) const;
  void write_objects(const std::vector<ObjectPose>& objects) const;
  void write_particles(const ParticleFrame& particles) const;
  void write_probes(const std::vector<ProbeSample>& probes) const;
  void flush() const;

  std::filesystem::path path_;
  Output output_;
  double density_ = 0.0;  // [kg/m^3] for the map of pressure
  bool exact_reference_ = false;
  std::size_t front_count_ = 0;
  std::size_t object_count_ = 0;
  std::size_t particle_count_ = 0;
  std::vector<hsize_t> grid_;  // ny, nx
  std::int64_t frames_ = 0;    // written so far
  hdf5::Handle file_;
  std::vector<OpenVariable> variables_;
  std::optional<DiskSpace> space_;
  std::optional<FileReserve> reserve_;
  std::vector<NamedField> last_fields_;  // of the frame written last
};

}  // namespace sandsim
