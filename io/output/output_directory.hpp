// The directory that a run writes into.
#pragma once

#include <filesystem>

namespace sandsim {

/// The files that sandsim writes, by their place in an output directory.
struct OutputFiles {
  explicit OutputFiles(const std::filesystem::path& directory);

  std::filesystem::path directory;
  std::filesystem::path scene;           // scene.resolved.yaml
  std::filesystem::path report;          // run.json
  std::filesystem::path series;          // series.h5
  std::filesystem::path xdmf;            // series.xdmf
  std::filesystem::path particles_xdmf;  // particles.xdmf
  std::filesystem::path log;             // log.txt
  std::filesystem::path checkpoint;      // checkpoint.h5
};

/// Makes the directory (and its parents) ready to be written to, and returns the names of the files in it.
/// One that is not empty is refused unless `overwrite` or `resume` is set. `overwrite` removes the files that sandsim
/// itself writes and nothing else. Throws OutputError.
OutputFiles prepare_output_directory(const std::filesystem::path& directory, bool overwrite, bool resume);

}  // namespace sandsim
