// Looks into a series without knowing its scene. Internal to io/output.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/hdf5/hdf5.hpp"
#include "solver/scene.hpp"

namespace sandsim {

/// A variable as it is found in a file.
struct StoredVariable {
  std::string name;
  std::vector<std::string> dimensions;  // names of the attached dimension scales; empty entries where there is none
  std::vector<hsize_t> extent;
  std::string units;
  bool numeric = false;
  bool bare_dimension = false;   // a dimension that has no coordinates
  std::size_t element_size = 0;  // [bytes]

  bool has_dimensions(const std::vector<std::string>& names) const { return dimensions == names; }
};

/// The series that `given` stands for: itself, or that of a results folder, finished or partial. Throws InputError if
/// there is nothing of that name.
std::filesystem::path series_path(const std::filesystem::path& given);

/// An open series, finished or partial. The caller holds an hdf5::Session. Functions throw hdf5::Failure.
class SeriesReader {
 public:
  explicit SeriesReader(const std::filesystem::path& path);

  hid_t file() const { return file_.id(); }
  const std::vector<StoredVariable>& variables() const { return variables_; }
  const StoredVariable* find(const std::string& name) const;
  std::vector<double> read_coordinate(const std::string& name) const;
  std::string attribute(const std::string& name) const;
  /// The grid of its cells, of which there are two at least.
  Grid grid() const;

  /// Frames that were completed: those that have a time.
  std::size_t frames() const { return times_.size(); }
  const std::vector<double>& times() const { return times_; }

 private:
  hdf5::Handle file_;
  std::vector<StoredVariable> variables_;
  std::vector<double> times_;
};

}  // namespace sandsim
