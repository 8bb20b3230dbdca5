// The files that a scene's result depends on.
#pragma once

#include <filesystem>
#include <vector>

#include "solver/scene.hpp"

namespace sandsim::cli {

/// Rasters of terrain, sand, friction and hbar, in the order of the scene. Files of references are left out: they may
/// come later, and change no cell. Names are relative to `folder`, the scene's own.
std::vector<std::filesystem::path> input_files(const Scene& scene, const std::filesystem::path& folder);

}  // namespace sandsim::cli
