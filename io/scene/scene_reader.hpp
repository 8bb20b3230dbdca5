// Scene files into scenes.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "io/scene/overrides.hpp"
#include "solver/scene.hpp"

namespace sandsim {

/// Reads and checks a scene file. `overrides` ("time.end=5 s", "sand.initial.0.depth=30 cm", values may be flow YAML;
/// "key=" removes the key) replace values before anything is read. File names in a scene are relative to its folder.
/// Warnings, one an entry, go to `warnings`.
/// Throws SceneError with all problems, one a line; InputError if only files are missing or unreadable.
Scene read_scene(const std::filesystem::path& file, std::span<const std::string> overrides = {},
                 std::vector<std::string>* warnings = nullptr);

/// The same with overrides that were written elsewhere than on the command line.
Scene read_scene(const std::filesystem::path& file, std::span<const Override> overrides,
                 std::vector<std::string>* warnings = nullptr);

/// The same for text. `name` stands for the file in messages; `directory` is the folder of relative file names.
Scene read_scene_text(const std::string& text, const std::string& name, const std::filesystem::path& directory,
                      std::span<const std::string> overrides = {}, std::vector<std::string>* warnings = nullptr);
Scene read_scene_text(const std::string& text, const std::string& name, const std::filesystem::path& directory,
                      std::span<const Override> overrides, std::vector<std::string>* warnings = nullptr);

}  // namespace sandsim
