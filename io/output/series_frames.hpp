// The frames of a run's series one by one, for commands that turn them into something else.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "solver/scene.hpp"

namespace sandsim {

class SeriesReader;

/// The particles of a frame that are to be drawn.
struct VisibleParticles {
  std::vector<std::array<double, 3>> positions;  // [m]
  std::vector<std::int64_t> ids;
  std::size_t hidden = 0;  // particles that are not among them
};

/// An open series. All functions throw InputError: "file: problem".
class SeriesFrames {
 public:
  /// `given` is a results folder, or a series.h5 or series.h5.partial. There is a frame at least.
  explicit SeriesFrames(const std::filesystem::path& given);
  ~SeriesFrames();
  SeriesFrames(const SeriesFrames&) = delete;
  SeriesFrames& operator=(const SeriesFrames&) = delete;

  const std::filesystem::path& path() const { return path_; }
  const std::string& title() const { return title_; }
  const Grid& grid() const { return grid_; }
  const std::vector<double>& times() const { return times_; }  // [s]

  bool has(const std::string& name) const;
  /// What has a value in every cell: once ("bed", the maxima), and in every frame.
  std::vector<std::string> maps() const;
  std::vector<std::string> fields() const;
  /// Whether its values are float32.
  bool single_precision(const std::string& name) const;
  /// The bed [m], x fastest.
  std::vector<double> bed() const;
  /// One of maps(), x fastest. NaN where there is no value.
  std::vector<double> map(const std::string& name) const;
  /// A field over time, as "depth", at a frame: x fastest, every value finite.
  std::vector<double> field(const std::string& name, std::size_t frame) const;
  VisibleParticles particles(std::size_t frame) const;

 private:
  template <class Read>
  auto reading(Read read) const;
  std::vector<std::string> names_of(const std::vector<std::string>& dimensions) const;
  void require_finite(const std::string& name, const std::vector<double>& values, const std::string& where) const;

  std::filesystem::path path_;
  std::unique_ptr<SeriesReader> reader_;
  std::string title_;
  Grid grid_;
  std::vector<double> times_;
};

}  // namespace sandsim
