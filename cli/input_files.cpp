#include "cli/input_files.hpp"

#include <variant>

#include "io/output/scene_hash.hpp"
#include "io/scene/resolved_scene.hpp"

namespace sandsim::cli {

namespace fs = std::filesystem;

std::vector<fs::path> input_files(const Scene& scene, const fs::path& folder) {
  std::vector<fs::path> files;
  const auto add = [&](const RasterFile& raster) { files.push_back(folder / raster.file); };
  const auto add_map = [&](const ScalarMap& map) {
    if (const auto* raster = std::get_if<RasterFile>(&map)) {
      add(*raster);
    }
  };
  for (const TerrainPart& part : scene.terrain) {
    if (const auto* raster = std::get_if<RasterTerrain>(&part)) {
      add(raster->file);
    }
  }
  for (const SandPart& part : scene.sand.initial) {
    if (const auto* raster = std::get_if<SandRaster>(&part)) {
      add(raster->file);
    }
  }
  if (scene.sand.friction_angle) {
    add_map(*scene.sand.friction_angle);
  }
  if (scene.sand.friction_coefficient) {
    add_map(*scene.sand.friction_coefficient);
  }
  add_map(scene.sand.hbar.scale);
  add_map(scene.sand.hbar.cap);
  for (const KinematicObject& object : scene.objects) {
    if (const auto* mesh = std::get_if<MeshShape>(&object.shape)) {
      files.push_back(folder / mesh->file.file);
    }
    if (const auto* sdf = std::get_if<SdfShape>(&object.shape)) {
      files.push_back(folder / sdf->file.file);
    }
    if (const auto* path = std::get_if<Path>(&object.motion)) {
      files.push_back(folder / path->file.file);
    }
  }
  return files;
}

std::vector<fs::path> reference_files(const Scene& scene, const fs::path& folder) {
  std::vector<fs::path> files;
  const auto add = [&](const auto& table) {
    std::error_code ignored;
    if (table && fs::is_regular_file(folder / table->file, ignored)) {
      files.push_back(folder / table->file);
    }
  };
  if (scene.reference) {
    add(scene.reference->profile);
    add(scene.reference->measured_profile);
    add(scene.reference->measured_front);
  }
  return files;
}

std::string hash_of(const Scene& scene, const fs::path& scene_file) {
  return scene_hash(resolved_scene(scene), input_files(scene, scene_file.parent_path()));
}

}  // namespace sandsim::cli
