// Where a run reads and writes, from what the command line says.
#pragma once

#include <filesystem>
#include <string>

namespace sandsim::cli {

/// The scene file itself: `given`, or given/scene.yaml if that is a folder.
std::filesystem::path scene_file(const std::string& given);

/// results/NAME, relative to the current directory. NAME is the file's name without its extension, or the name of its
/// folder for a scene.yaml.
std::filesystem::path default_output_directory(const std::filesystem::path& scene_file);

}  // namespace sandsim::cli
