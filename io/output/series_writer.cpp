#include "io/output/series_writer.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "io/hdf5/hdf5.hpp"
#include "io/output/atomic_file.hpp"
#include "io/output/series_file.hpp"
#include "solver/errors.hpp"

namespace sandsim {
namespace {

namespace fs = std::filesystem;

/// The file to go on with, under its partial name. A finished one becomes partial again.
fs::path find_series_to_resume(const fs::path& path) {
  const fs::path partial = partial_series_path(path);
  std::error_code ignored;
  if (fs::exists(partial, ignored)) return partial;
  if (!fs::exists(path, ignored)) {
    throw InputError(
        fmt::format("{}: cannot resume: neither it nor {} is there", path.string(), partial.filename().string()));
  }
  rename_durably(path, partial);
  return partial;
}

}  // namespace

fs::path partial_series_path(const fs::path& path) {
  fs::path partial = path;
  partial += ".partial";
  return partial;
}

SeriesWriter::SeriesWriter(SeriesSettings settings) : settings_(std::move(settings)) {}

SeriesWriter::~SeriesWriter() {
  const hdf5::Session session;
  file_.reset();
}

void SeriesWriter::begin(const Scene& scene, const StaticFields& fields) {
  const hdf5::Session session;
  const fs::path partial = partial_series_path(settings_.path);
  try {
    if (settings_.resume_frames) {
      const fs::path found = find_series_to_resume(settings_.path);
      file_ = std::make_unique<SeriesFile>(SeriesFile::reopen(found, scene, settings_, *settings_.resume_frames));
    } else {
      file_ = std::make_unique<SeriesFile>(SeriesFile::create(partial, scene, settings_));
      file_->write_bed(fields.bed);
    }
  } catch (const hdf5::Failure& failure) {
    file_.reset();
    const std::string message = fmt::format("{}: {}", partial.string(), failure.what());
    if (settings_.resume_frames) throw InputError(message);
    throw OutputError(message);
  } catch (...) {
    file_.reset();
    throw;
  }
}

void SeriesWriter::frame(Frame frame) {
  const hdf5::Session session;
  const std::string partial = partial_series_path(settings_.path).string();
  if (!file_) throw OutputError(partial + ": not open, because of an earlier error");
  try {
    file_->append(std::move(frame));
  } catch (const hdf5::Failure& failure) {
    file_.reset();
    throw OutputError(fmt::format("{}: {}", partial, failure.what()));
  } catch (...) {
    // The file must not change any more: what is in it is whole.
    file_.reset();
    throw;
  }
}

void SeriesWriter::end(const FinalFields& fields) {
  const hdf5::Session session;
  const fs::path partial = partial_series_path(settings_.path);
  if (!file_) throw OutputError(partial.string() + ": not open, because of an earlier error");
  try {
    file_->write_maxima(fields);
    file_->close();
    file_->verify();
    file_.reset();
  } catch (const hdf5::Failure& failure) {
    file_.reset();
    throw OutputError(fmt::format("{}: {}", partial.string(), failure.what()));
  } catch (...) {
    file_.reset();
    throw;
  }
  rename_durably(partial, settings_.path);
}

}  // namespace sandsim
