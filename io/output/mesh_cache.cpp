#include "io/output/mesh_cache.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <memory>
#include <optional>
#include <string_view>
#include <type_traits>
#include <variant>

#include "io/output/atomic_file.hpp"
#include "io/output/file_lock.hpp"
#include "io/output/scene_hash.hpp"
#include "solver/objects/mesh.hpp"

namespace sandsim {

namespace {

/// To be raised whenever bake() gives other bits or the layout below changes.
constexpr std::string_view magic = "sandsim baked mesh 1\n";

/// What stands between the magic and the samples.
struct Header {
  std::uint64_t key = 0;
  std::int64_t points[3] = {};
  double origin[3] = {};
  double spacing = 0.0;
  std::uint64_t defects[4] = {};
};
static_assert(std::is_trivially_copyable_v<Header> && sizeof(Header) == 12 * 8, "written as it lies in memory");

template <class Item>
std::string_view bytes_of(const Item* items, std::size_t count) {
  return {reinterpret_cast<const char*>(items), count * sizeof(Item)};
}

std::uint64_t hash_of(std::string_view bytes) {
  ContentHash hash;
  hash.update(bytes);
  return hash.value();
}

std::uint64_t key_of(const objects::TriangleMesh& mesh, int resolution) {
  static_assert(std::has_unique_object_representations_v<std::array<std::uint32_t, 3>>);
  ContentHash hash;
  hash.update(magic);
  hash.update(fmt::format("{} {} {}\n", resolution, mesh.vertices.size(), mesh.triangles.size()));
  hash.update(bytes_of(mesh.vertices.data(), mesh.vertices.size()));
  hash.update(bytes_of(mesh.triangles.data(), mesh.triangles.size()));
  return hash.value();
}

std::string encode(const objects::BakedMesh& baked, std::uint64_t key) {
  const objects::DistanceGrid& g = baked.grid;
  const objects::MeshDefects& d = baked.defects;
  const Header header{key,
                      {g.points[0], g.points[1], g.points[2]},
                      {g.origin.x, g.origin.y, g.origin.z},
                      g.spacing,
                      {d.open_edges, d.non_manifold_edges, d.flipped_triangles, d.degenerate_triangles}};
  std::string bytes(magic);
  bytes += bytes_of(&header, 1);
  bytes += bytes_of(g.values.data(), g.values.size());
  const std::uint64_t check = hash_of(bytes);
  return bytes += bytes_of(&check, 1);
}

/// Nothing unless the bytes are whole and belong to the key.
std::optional<objects::BakedMesh> decode(std::string_view bytes, std::uint64_t key) {
  Header header;
  const std::size_t start = magic.size() + sizeof(Header);
  if (bytes.size() < start + sizeof(std::uint64_t) || !bytes.starts_with(magic)) return std::nullopt;
  std::uint64_t check = 0;
  std::memcpy(&check, bytes.data() + bytes.size() - sizeof(check), sizeof(check));
  if (check != hash_of(bytes.substr(0, bytes.size() - sizeof(check)))) return std::nullopt;
  std::memcpy(&header, bytes.data() + magic.size(), sizeof(header));
  const std::string_view samples = bytes.substr(start, bytes.size() - start - sizeof(check));
  std::uint64_t count = 1;
  for (const std::int64_t points : header.points) {
    if (points < 2 || points > objects::most_resolution) return std::nullopt;
    count *= static_cast<std::uint64_t>(points);
  }
  if (header.key != key || samples.size() != count * sizeof(float)) return std::nullopt;
  objects::BakedMesh baked;
  for (std::size_t axis = 0; axis < 3; ++axis) baked.grid.points[axis] = static_cast<int>(header.points[axis]);
  baked.grid.origin = {header.origin[0], header.origin[1], header.origin[2]};
  baked.grid.spacing = header.spacing;
  baked.grid.values.resize(count);
  std::memcpy(baked.grid.values.data(), samples.data(), samples.size());
  baked.defects = {header.defects[0], header.defects[1], header.defects[2], header.defects[3]};
  return baked;
}

/// Empty if the file is not there or cannot be read.
std::string content(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

}  // namespace

CachedMesh bake_with_cache(const objects::TriangleMesh& mesh, int resolution, const std::filesystem::path& folder,
                           const std::function<void(double)>& progress) {
  const std::uint64_t key = key_of(mesh, resolution);
  const std::filesystem::path file = folder / fmt::format("baked-{:016x}.bin", key);
  if (std::optional<objects::BakedMesh> kept = decode(content(file), key)) return {std::move(*kept), true, file};
  // Cases of a sweep want the same mesh at the same time: one bakes it, the others wait and find it.
  const FileLock lock(folder, FileLock::Mode::wait);
  if (std::optional<objects::BakedMesh> kept = decode(content(file), key)) return {std::move(*kept), true, file};
  CachedMesh result{objects::bake(mesh, resolution, progress), false, file};
  write_file_atomically(file, encode(result.baked, key));
  return result;
}

void bake_meshes(Scene& scene, const std::filesystem::path& folder,
                 const std::function<void(const std::string&, double)>& progress) {
  for (KinematicObject& object : scene.objects) {
    auto* const shape = std::get_if<MeshShape>(&object.shape);
    if (shape == nullptr) continue;
    std::function<void(double)> own_progress;
    if (progress) own_progress = [&](double fraction) { progress(object.name, fraction); };
    CachedMesh cached = bake_with_cache(*shape->file.mesh, shape->resolution, folder, own_progress);
    shape->file.distance = std::make_shared<objects::DistanceGrid>(std::move(cached.baked.grid));
  }
}

}  // namespace sandsim
