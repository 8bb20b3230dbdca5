// The output directory of a sweep:
//   sweep.json         what the sweep is: scene, keys, cases and their folders
//   cases/HASH/        the results of a run each
//   summary.csv, .h5   a table of all cases
#pragma once

#include <filesystem>

#include "cli/sweep/sweep.hpp"
#include "io/output/file_lock.hpp"

namespace sandsim::cli {

struct SweepFiles {
  explicit SweepFiles(const std::filesystem::path& directory);

  std::filesystem::path directory;
  std::filesystem::path manifest;  // sweep.json
  std::filesystem::path csv;       // summary.csv
  std::filesystem::path series;    // summary.h5
  std::filesystem::path script;    // sweep.sbatch, for Slurm
  std::filesystem::path lock;      // held by the process that runs the sweep
};

/// True if the directory holds a sweep that can be gone on with.
bool holds_sweep(const std::filesystem::path& directory);

/// Reads sweep.json. Throws InputError.
Sweep read_manifest(const SweepFiles& files);

/// The sweep's lock; throws OutputError if another process holds it.
FileLock lock_sweep(const SweepFiles& files);

/// Makes the directory ready for the sweep and writes sweep.json into it. One that holds the same sweep, or a part of
/// it, keeps its cases; one that holds another sweep or anything else is refused unless `overwrite` is set, which
/// removes the results of the cases that were there, and nothing else. Returns the lock of the sweep, to be kept while
/// its cases run. Throws OutputError.
[[nodiscard]] FileLock prepare_sweep_directory(const Sweep& sweep, const SweepFiles& files, bool overwrite);

}  // namespace sandsim::cli
