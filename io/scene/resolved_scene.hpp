// A scene as a scene file again, with all defaults and in SI units.
#pragma once

#include <filesystem>
#include <string>

#include "solver/scene.hpp"

namespace sandsim {

/// YAML that reads back to the same scene, bit for bit. Keys that do not apply, and those without a value, are left
/// out. Relative file names stay as the scene has them; with a `directory`, they are written as names inside it.
std::string resolved_scene(const Scene& scene, const std::filesystem::path& directory = {});

}  // namespace sandsim
