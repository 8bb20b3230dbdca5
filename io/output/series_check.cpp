// Reading a series back: to go on with it, and to make sure that it is whole.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "io/output/run_report.hpp"
#include "io/output/series_create.hpp"
#include "io/output/series_file.hpp"
#include "solver/errors.hpp"

namespace sandsim {
namespace {

using hdf5::Handle;
using hdf5::require;

/// Throws InputError unless the data set is there and has the shape and type that the scene gives it.
void require_same_shape(hid_t file, const Variable& variable, const Scene& scene, const std::string& path) {
  if (!hdf5::exists(file, variable.name)) {
    throw InputError(
        fmt::format("{}: cannot resume: it has no {}; was it written for another scene?", path, variable.name));
  }
  const Handle dataset = hdf5::open_dataset(file, variable.name);
  std::vector<hsize_t> found = hdf5::extent(dataset.id());
  std::vector<hsize_t> expected = initial_extent(variable, scene);
  if (variable.over_time() && !found.empty()) found.front() = 0;
  if (found != expected) {
    throw InputError(fmt::format("{}: cannot resume: {} has {} values where the scene has {}", path, variable.name,
                                 fmt::join(found, " x "), fmt::join(expected, " x ")));
  }
  if (variable.type != NumberType::text &&
      hdf5::element_size(dataset.id()) != H5Tget_size(stored_type(variable, scene.numerics.precision))) {
    throw InputError(fmt::format("{}: cannot resume: {} is of another precision", path, variable.name));
  }
}

void add_to_history(hid_t file, const std::string& history) {
  const std::string before = hdf5::read_text_attribute(file, "history").value_or("");
  hdf5::write_attribute(file, "history", before + "\n" + time_stamp() + " resumed: " + history);
}

template <class Number>
bool same_bits(hid_t dataset, const std::vector<Number>& expected, const hdf5::Block& block) {
  std::vector<Number> found(expected.size());
  hdf5::read(dataset, hdf5::native_type<Number>(), found.data(), block);
  return std::memcmp(found.data(), expected.data(), expected.size() * sizeof(Number)) == 0;
}

/// A chunk that is missing would read as NaN, which is only noticed much later.
void require_all_chunks(hid_t dataset, const Variable& variable, const std::vector<hsize_t>& size) {
  const std::string tried = "count the chunks of " + variable.name;
  const Handle properties(H5Dget_create_plist(dataset), H5Pclose, tried);
  std::vector<hsize_t> chunk(size.size());
  require(H5Pget_chunk(properties.id(), static_cast<int>(chunk.size()), chunk.data()), tried);
  hsize_t expected = 1;
  for (std::size_t axis = 0; axis < size.size(); ++axis) expected *= (size[axis] + chunk[axis] - 1) / chunk[axis];
  hsize_t found = 0;
  const Handle space(H5Dget_space(dataset), H5Sclose, tried);
  require(H5Dget_num_chunks(dataset, space.id(), &found), tried);
  if (found != expected) {
    throw hdf5::Failure(fmt::format("{} has {} chunks on the disk, not {}", variable.name, found, expected));
  }
}

void require_times(hid_t file, std::int64_t frames) {
  const std::vector<double> time = hdf5::read_all<double>(file, "time");
  if (static_cast<std::int64_t>(time.size()) != frames) {
    throw hdf5::Failure(fmt::format("it holds {} frames, not {}", time.size(), frames));
  }
  if (!std::all_of(time.begin(), time.end(), [](double t) { return std::isfinite(t); }) ||
      !std::is_sorted(time.begin(), time.end())) {
    throw hdf5::Failure("its times are not in order");
  }
}

}  // namespace

SeriesFile SeriesFile::reopen(const std::filesystem::path& path, const Scene& scene, const SeriesSettings& settings,
                              std::int64_t frames) {
  hdf5::Handle file = hdf5::open_file(path, true);
  for (const Variable& variable : series_layout(scene)) {
    require_same_shape(file.id(), variable, scene, path.string());
  }
  add_to_history(file.id(), settings.history);
  SeriesFile series(path, scene, std::move(file));
  const hsize_t found = hdf5::extent(series.find("time").dataset.id()).front();
  if (found < static_cast<hsize_t>(frames)) {
    throw InputError(fmt::format("{}: cannot resume: it holds {} frames, and the checkpoint was written after {}",
                                 path.string(), found, frames));
  }
  // The times go first: a run killed in between leaves no frame that is only half there.
  series.extend(series.find("time"), static_cast<hsize_t>(frames));
  series.flush();
  for (const OpenVariable& open : series.variables_) {
    if (open.variable.over_time()) series.extend(open, static_cast<hsize_t>(frames));
  }
  series.flush();
  series.frames_ = frames;
  return series;
}

void SeriesFile::verify() const {
  try {
    const Handle file = hdf5::open_file(path_, false);
    require_times(file.id(), frames_);
    for (const OpenVariable& open : variables_) {
      if (!open.variable.over_time()) continue;
      const Handle dataset = hdf5::open_dataset(file.id(), open.variable.name);
      const std::vector<hsize_t> size = hdf5::extent(dataset.id());
      if (size.front() != static_cast<hsize_t>(frames_)) {
        throw hdf5::Failure(fmt::format("{} holds {} frames, not {}", open.variable.name, size.front(), frames_));
      }
      // The exact solution is not known at all times: only its rows may have holes.
      if (frames_ > 0 && open.variable.name != "reference_depth") {
        require_all_chunks(dataset.id(), open.variable, size);
      }
    }
    const hdf5::Block last{{static_cast<hsize_t>(frames_ - 1), 0, 0}, {1, grid_[0], grid_[1]}};
    for (const NamedField& field : last_fields_) {
      const Handle dataset = hdf5::open_dataset(file.id(), field.name);
      const auto same = [&](const auto& numbers) { return same_bits(dataset.id(), numbers, last); };
      if (!std::visit(same, field.values)) throw hdf5::Failure("the last frame's " + field.name + " reads differently");
    }
  } catch (const hdf5::Failure& failure) {
    throw OutputError(fmt::format("{}: read back after writing: {}", path_.string(), failure.what()));
  }
}

}  // namespace sandsim
