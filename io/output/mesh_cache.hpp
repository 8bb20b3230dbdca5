// Baked meshes kept in files, so that a second run does not bake them again.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "solver/objects/bake.hpp"
#include "solver/scene.hpp"

namespace sandsim {

struct CachedMesh {
  objects::BakedMesh baked;
  bool is_from_cache = false;
  std::filesystem::path file;  // which holds it now
};

/// The mesh baked as objects::bake() does, from `folder`/baked-HASH.bin if that is there and whole; else it is baked
/// and written there. HASH is that of the mesh, the resolution and the version of the format, so that what has changed
/// is baked anew; a damaged file is replaced. Throws OutputError if the file cannot be written, and what bake() throws.
CachedMesh bake_with_cache(const objects::TriangleMesh& mesh, int resolution, const std::filesystem::path& folder,
                           const std::function<void(double)>& progress = {});

/// Bakes the meshes of a scene's objects so that the solver finds them in MeshFile::distance. `progress` is told each
/// object's name and the finished fraction.
void bake_meshes(Scene& scene, const std::filesystem::path& folder,
                 const std::function<void(const std::string&, double)>& progress = {});

}  // namespace sandsim
