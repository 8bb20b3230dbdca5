// checkpoint.h5: all that is needed to go on with a run bit for bit.
#pragma once

#include <filesystem>
#include <string>

#include "solver/simulation.hpp"

namespace sandsim {

/// Writes the checkpoint under a temporary name, syncs and renames it: an older one stays until then.
/// Throws OutputError.
void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint, const std::string& scene_hash);

/// Throws InputError if the file is missing, damaged (checksums), or of another scene.
Checkpoint read_checkpoint(const std::filesystem::path& path, const std::string& scene_hash);

}  // namespace sandsim
