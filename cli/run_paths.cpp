#include "cli/run_paths.hpp"

#include <system_error>

namespace sandsim::cli {

namespace fs = std::filesystem;

fs::path scene_file(const std::string& given) {
  std::error_code ignored;  // Whoever opens the file reports what is wrong with it.
  return fs::is_directory(given, ignored) ? fs::path(given) / "scene.yaml" : fs::path(given);
}

fs::path default_output_directory(const fs::path& scene_file) {
  const std::string stem = scene_file.stem().string();
  const std::string folder = fs::absolute(scene_file).lexically_normal().parent_path().filename().string();
  return fs::path("results") / (stem == "scene" && !folder.empty() ? folder : stem);
}

}  // namespace sandsim::cli
