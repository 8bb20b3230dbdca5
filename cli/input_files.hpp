// The files that a scene's result depends on.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "solver/scene.hpp"

namespace sandsim::cli {

/// Rasters and polygons of terrain, sand, friction and hbar, meshes, signed distances and paths, in the order of the
/// scene; with each of the first two the files beside it that say where it lies or belong to it (.prj, .dbf). Files of
/// references are left out: they may come later, and change no cell. Names are relative to `folder`, the scene's own.
std::vector<std::filesystem::path> input_files(const Scene& scene, const std::filesystem::path& folder);

/// Files of references that are there, likewise.
std::vector<std::filesystem::path> reference_files(const Scene& scene, const std::filesystem::path& folder);

/// The hash that a run of the scene has in its report: of the scene, wherever it lies, and of its input files.
std::string hash_of(const Scene& scene, const std::filesystem::path& scene_file);

}  // namespace sandsim::cli
