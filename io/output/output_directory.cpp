#include "io/output/output_directory.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <vector>

#include "io/output/series_writer.hpp"
#include "solver/errors.hpp"

namespace sandsim {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& problem) {
  throw OutputError(fmt::format("{}: {}", path.string(), problem));
}

/// Everything that a run may leave behind, unfinished files included.
std::vector<fs::path> files_of_a_run(const OutputFiles& files) {
  std::vector<fs::path> all{files.scene,          files.report, files.series,    files.xdmf,
                            files.particles_xdmf, files.log,    files.checkpoint};
  all.push_back(partial_series_path(files.series));
  for (const fs::path& written : {files.scene, files.report, files.xdmf, files.particles_xdmf, files.checkpoint}) {
    all.push_back(written.string() + ".tmp");
  }
  return all;
}

void remove_files_of_a_run(const OutputFiles& files) {
  for (const fs::path& path : files_of_a_run(files)) {
    std::error_code error;
    const fs::file_status status = fs::symlink_status(path, error);
    if (!fs::exists(status)) continue;
    if (!fs::is_regular_file(status) && !fs::is_symlink(status)) fail(path, "is not a file: will not overwrite it");
    if (!fs::remove(path, error) || error) fail(path, "could not be removed (" + error.message() + ")");
  }
}

/// Permissions alone do not tell: the file system may be mounted read-only.
void require_writable(const fs::path& directory) {
  const fs::path probe = directory / fmt::format(".sandsim-{}.tmp", ::getpid());
  const int descriptor = ::open(probe.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (descriptor < 0) fail(directory, fmt::format("cannot be written to ({})", std::strerror(errno)));
  ::close(descriptor);
  ::unlink(probe.c_str());
}

}  // namespace

OutputFiles::OutputFiles(const fs::path& in)
    : directory(in),
      scene(in / "scene.resolved.yaml"),
      report(in / "run.json"),
      series(in / "series.h5"),
      xdmf(in / "series.xdmf"),
      particles_xdmf(in / "particles.xdmf"),
      log(in / "log.txt"),
      checkpoint(in / "checkpoint.h5") {}

OutputFiles prepare_output_directory(const fs::path& directory, bool overwrite, bool resume) {
  const OutputFiles files(directory);
  std::error_code error;
  const fs::file_status status = fs::status(directory, error);
  if (fs::exists(status) && !fs::is_directory(status)) fail(directory, "is not a directory");
  if (!fs::exists(status)) {
    fs::create_directories(directory, error);
    if (error) fail(directory, "could not be created (" + error.message() + ")");
  }
  const bool empty = fs::is_empty(directory, error);
  if (error) fail(directory, "cannot be read (" + error.message() + ")");
  if (!empty && !overwrite && !resume) {
    fail(directory,
         "the output directory is not empty. Go on with the run in it with --resume, replace it with "
         "--overwrite, or name another one with -o?");
  }
  require_writable(directory);
  if (overwrite && !resume) remove_files_of_a_run(files);
  return files;
}

}  // namespace sandsim
