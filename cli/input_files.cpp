#include "cli/input_files.hpp"

#include <initializer_list>
#include <string>
#include <system_error>
#include <variant>

#include "io/output/scene_hash.hpp"
#include "io/scene/resolved_scene.hpp"

namespace sandsim::cli {

namespace fs = std::filesystem;

namespace {

void add_if_there(const fs::path& file, std::vector<fs::path>& files) {
  std::error_code ignored;
  if (fs::is_regular_file(file, ignored)) {
    files.push_back(file);
  }
}

}  // namespace

std::vector<fs::path> input_files(const Scene& scene, const fs::path& folder) {
  std::vector<fs::path> files;
  const auto add_file = [&](const std::string& name, std::initializer_list<const char*> companions) {
    const fs::path file = folder / name;
    files.push_back(file);
    for (const char* extension : companions) {
      add_if_there(fs::path(file).replace_extension(extension), files);
    }
    add_if_there(file.string() + ".aux.xml", files);
  };
  const auto add = [&](const RasterFile& raster) { add_file(raster.file, {".prj", ".tfw", ".wld"}); };
  const auto add_polygons = [&](const PolygonFile& layer) { add_file(layer.file, {".shx", ".dbf", ".prj", ".cpg"}); };
  const auto add_map = [&](const ScalarMap& map) {
    if (const auto* raster = std::get_if<RasterFile>(&map)) {
      add(*raster);
    } else if (const auto* zones = std::get_if<ZoneMap>(&map)) {
      add_polygons(zones->polygons);
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
    } else if (const auto* polygon = std::get_if<SandPolygon>(&part)) {
      add_polygons(polygon->file);
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
