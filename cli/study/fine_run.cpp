#include "cli/study/fine_run.hpp"

#include <fmt/format.h>

#include <optional>

#include "cli/input_files.hpp"
#include "io/output/atomic_file.hpp"
#include "io/output/scene_hash.hpp"
#include "io/output/version.hpp"
#include "io/raster/read_raster.hpp"
#include "io/raster/write_npy.hpp"
#include "io/scene/resolved_scene.hpp"
#include "solver/errors.hpp"

namespace sandsim::cli {

namespace fs = std::filesystem;

namespace {

std::string hash_of(const StudyRun& run) {
  ContentHash hash;
  hash.update(scene_hash(resolved_scene(run.setup), input_files(run.setup, run.folder)));
  hash.update(source_line());
  return fmt::format("{:016x}", hash.value());
}

/// Nothing if the file is not there or not whole: then it is made anew.
std::optional<std::vector<double>> kept_depth(const fs::path& file, const Grid& grid) {
  if (!fs::exists(file)) {
    return std::nullopt;
  }
  try {
    Raster raster = read_raster(file);
    if (raster.nx == static_cast<std::size_t>(grid.cells[0]) && raster.ny == static_cast<std::size_t>(grid.cells[1])) {
      return std::move(raster.values);
    }
  } catch (const InputError&) {
  }
  return std::nullopt;
}

}  // namespace

FineDepth fine_depth(const StudyRun& run, const fs::path& folder, const RoundOptions& options) {
  FineDepth fine;
  fine.file = folder / ("fine-" + hash_of(run) + ".npy");
  const Grid& grid = run.setup.grid;
  if (auto depth = kept_depth(fine.file, grid)) {
    fine.depth = std::move(*depth);
    fine.is_from_file = true;
    return fine;
  }
  TimedResult result = run_once({&run.setup, Device::cpu, 0, false}, options);
  if (result.report.exit_code != ExitCode::done) {
    throw Error(result.report.exit_code,
                fmt::format("the fine run of '{}' did not end: {}", run.name, result.report.message));
  }
  fine.depth = std::move(result.depth);
  fine.seconds = result.report.wall_time;
  write_file_atomically(fine.file, npy_bytes(fine.depth, static_cast<std::size_t>(grid.cells[0]),
                                             static_cast<std::size_t>(grid.cells[1])));
  return fine;
}

}  // namespace sandsim::cli
