#include "cli/stress/stress_files.hpp"

#include <fmt/format.h>

#include <fstream>
#include <sstream>
#include <string_view>

#include "io/raster/write_npy.hpp"
#include "io/scene/resolved_scene.hpp"
#include "solver/errors.hpp"

namespace sandsim::cli {

namespace fs = std::filesystem;

namespace {

/// These files are many and small, and can be made again: they are not synced to the disk one by one.
void write_file(const fs::path& path, std::string_view bytes) {
  std::ofstream file(path, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file) {
    throw OutputError(path.string() + ": cannot be written");
  }
}

std::string read_file(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

/// The scene as the trial runs it; its own text if it cannot be read.
std::string failing_scene(const Trial& trial, const StressFiles& files) {
  const fs::path folder = fs::absolute(trial.scene).parent_path();
  // Names of rasters are relative to the failures, so that the whole directory can be moved.
  const bool is_own = folder == fs::absolute(files.scenes);
  try {
    return resolved_scene(trial_scene(trial), is_own ? fs::path("..") / files.scenes.filename() : folder);
  } catch (const Error&) {
    return read_file(trial.scene);
  }
}

}  // namespace

StressFiles::StressFiles(const fs::path& where)
    : directory(where),
      scenes(where / "scenes"),
      failures(where / "failures"),
      csv(where / "stress.csv"),
      maps(where / "maps.csv"),
      markdown(where / "stress.md") {}

StressFiles prepare_stress_directory(const fs::path& directory, bool overwrite) {
  const StressFiles files(directory);
  try {
    if (fs::exists(directory) && !fs::is_empty(directory)) {
      if (!overwrite) {
        throw OutputError(directory.string() +
                          ": the directory is not empty\n  choose another one with -o, or replace the results in it "
                          "with --overwrite");
      }
      for (const fs::path& own : {files.scenes, files.failures, files.csv, files.maps, files.markdown}) {
        fs::remove_all(own);
      }
    }
    fs::create_directories(files.scenes);
    fs::create_directories(files.failures);
  } catch (const fs::filesystem_error& error) {
    throw OutputError(error.what());
  }
  return files;
}

fs::path write_case(const StressCase& its, const fs::path& folder) {
  for (const CaseRaster& raster : its.rasters) {
    write_file(folder / raster.file,
               npy_bytes(raster.values, static_cast<std::size_t>(raster.nx), static_cast<std::size_t>(raster.ny)));
  }
  const fs::path scene = folder / (its.name + ".yaml");
  write_file(scene, its.scene.text(its.meaning));
  return scene;
}

void write_failure(const StressRow& row, const StressCase& its, const Trial& trial, const StressFiles& files) {
  std::string text = fmt::format("# {}: {}\n# Fails with the {} scheme in {}:\n", its.name, its.meaning,
                                 row.variant.name(), row.variant.precision_name());
  for (const Finding& finding : row.findings) {
    text += fmt::format("# - {}: {}\n", finding.criterion, finding.what);
  }
  write_file(files.failures / fmt::format("{}_{}.yaml", its.name, row.variant.file_name()),
             text + failing_scene(trial, files));
}

}  // namespace sandsim::cli
