#include "io/output/series_frames.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "io/output/series_reader.hpp"
#include "solver/errors.hpp"

namespace sandsim {

namespace fs = std::filesystem;

/// Calls `read` within a session of the library.
template <class Read>
auto SeriesFrames::reading(Read read) const {
  const hdf5::Session session;
  try {
    return read();
  } catch (const hdf5::Failure& failure) {
    throw InputError(fmt::format("{}: {}", path_.string(), failure.what()));
  }
}

SeriesFrames::SeriesFrames(const fs::path& given) : path_(series_path(given)) {
  reading([&] {
    auto reader = std::make_unique<SeriesReader>(path_);  // to be closed within the session if something is wrong
    title_ = reader->attribute("title");
    grid_ = reader->grid();
    times_ = reader->times();
    if (times_.empty()) throw hdf5::Failure("it has no frames");
    reader_ = std::move(reader);
  });
}

SeriesFrames::~SeriesFrames() {
  const hdf5::Session session;
  reader_.reset();
}

bool SeriesFrames::has(const std::string& name) const {
  return reader_->find(name) != nullptr;
}

namespace {

hdf5::Handle open_of_rank(const SeriesReader& reader, const std::string& name, std::size_t rank,
                          const std::string& remedy) {
  const StoredVariable* variable = reader.find(name);
  if (variable == nullptr) throw hdf5::Failure(fmt::format("it holds no {}; {}", name, remedy));
  if (!variable->numeric || variable->extent.size() != rank) {
    throw hdf5::Failure(fmt::format("{} is no array of numbers with {} dimensions", name, rank));
  }
  return hdf5::open_dataset(reader.file(), name);
}

/// Throws unless the variable has these lengths; the first one, that of time, may be longer.
void require_extent(const SeriesReader& reader, const std::string& name, const std::vector<hsize_t>& expected) {
  std::vector<hsize_t> extent = reader.find(name)->extent;
  if (extent.size() == expected.size() && extent.front() >= expected.front()) extent.front() = expected.front();
  if (extent != expected)
    throw hdf5::Failure(name + " does not have the size of the grid, the frames or the particles");
}

}  // namespace

std::vector<std::string> SeriesFrames::names_of(const std::vector<std::string>& dimensions) const {
  std::vector<std::string> names;
  for (const StoredVariable& variable : reader_->variables()) {
    if (variable.numeric && variable.has_dimensions(dimensions)) names.push_back(variable.name);
  }
  return names;
}

std::vector<std::string> SeriesFrames::maps() const {
  return names_of({"y", "x"});
}

std::vector<std::string> SeriesFrames::fields() const {
  return names_of({"time", "y", "x"});
}

bool SeriesFrames::single_precision(const std::string& name) const {
  return reader_->find(name)->element_size == sizeof(float);
}

std::vector<double> SeriesFrames::map(const std::string& name) const {
  std::vector<double> values(grid_.cell_count());
  reading([&] {
    const hdf5::Handle dataset = open_of_rank(*reader_, name, 2, "the run needs output.frames");
    const auto nx = static_cast<hsize_t>(grid_.cells[0]), ny = static_cast<hsize_t>(grid_.cells[1]);
    require_extent(*reader_, name, {ny, nx});
    hdf5::read(dataset.id(), H5T_NATIVE_DOUBLE, values.data());
  });
  return values;
}

std::vector<double> SeriesFrames::bed() const {
  std::vector<double> values = map("bed");
  require_finite("bed", values, "");
  return values;
}

std::vector<double> SeriesFrames::field(const std::string& name, std::size_t frame) const {
  std::vector<double> values(grid_.cell_count());
  reading([&] {
    const hdf5::Handle dataset = open_of_rank(*reader_, name, 3, "the run needs output.fields with " + name);
    const auto nx = static_cast<hsize_t>(grid_.cells[0]), ny = static_cast<hsize_t>(grid_.cells[1]);
    require_extent(*reader_, name, {times_.size(), ny, nx});
    hdf5::read(dataset.id(), H5T_NATIVE_DOUBLE, values.data(), {{frame, 0, 0}, {1, ny, nx}});
  });
  require_finite(name, values, fmt::format(" of frame {}", frame));
  return values;
}

VisibleParticles SeriesFrames::particles(std::size_t frame) const {
  return reading([&] {
    const std::string remedy = "the scene needs 'particles'";
    const hdf5::Handle position = open_of_rank(*reader_, "particle_position", 3, remedy);
    const hdf5::Handle id = open_of_rank(*reader_, "particle_id", 2, remedy);
    const hdf5::Handle visible = open_of_rank(*reader_, "particle_visible", 2, remedy);
    const hsize_t count = reader_->find("particle_position")->extent[1];
    require_extent(*reader_, "particle_position", {times_.size(), count, 3});
    for (const char* name : {"particle_id", "particle_visible"}) require_extent(*reader_, name, {times_.size(), count});
    std::vector<std::array<double, 3>> positions(count);
    std::vector<std::int64_t> ids(count), shown(count);
    if (count > 0) {
      hdf5::read(position.id(), H5T_NATIVE_DOUBLE, positions.data(), {{frame, 0, 0}, {1, count, 3}});
      hdf5::read(id.id(), H5T_NATIVE_INT64, ids.data(), {{frame, 0}, {1, count}});
      hdf5::read(visible.id(), H5T_NATIVE_INT64, shown.data(), {{frame, 0}, {1, count}});
    }
    VisibleParticles particles;
    for (std::size_t k = 0; k < count; ++k) {
      if (shown[k] == 0) {
        ++particles.hidden;
        continue;
      }
      particles.positions.push_back(positions[k]);
      particles.ids.push_back(ids[k]);
    }
    return particles;
  });
}

void SeriesFrames::require_finite(const std::string& name, const std::vector<double>& values,
                                  const std::string& where) const {
  const auto width = static_cast<std::size_t>(grid_.cells[0]);
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (std::isfinite(values[k])) continue;
    throw InputError(fmt::format("{}: {}{} is {} in cell ({}, {}), counted from 0", path_.string(), name, where,
                                 values[k], k % width, k / width));
  }
}

}  // namespace sandsim
