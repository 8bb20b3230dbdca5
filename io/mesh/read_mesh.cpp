#include "io/mesh/read_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <new>

#include "io/mesh/faces.hpp"
#include "io/raster/source_text.hpp"
#include "solver/errors.hpp"

namespace sandsim {

void add_polygon(objects::TriangleMesh& mesh, std::span<const std::uint32_t> corners) {
  if (corners.size() < 3) return;
  const std::size_t middle = corners.size() / 2;
  add_polygon(mesh, corners.first(middle + 1));
  mesh.triangles.push_back({corners.front(), corners[middle], corners.back()});
  add_polygon(mesh, corners.subspan(middle));
}

void OddParts::settle(objects::TriangleMesh& mesh, Warnings* warnings,
                      const std::function<std::string(std::string_view, const std::string&)>& describe) const {
  if (faces_ > 0) {
    const std::string what = "a face with fewer than three corners is left out";
    warn(warnings, describe(first_face_, faces_ == 1 ? what : fmt::format("{}, as are {} more", what, faces_ - 1)));
  }
  if (vertices_.empty()) return;
  std::vector<bool> is_used(mesh.vertices.size(), false);
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) is_used[corner] = true;
  }
  for (const auto& [vertex, place] : vertices_) {
    if (is_used[vertex]) throw InputError(describe(place, "a vertex of a face is not finite"));
    mesh.vertices[vertex] = {};
  }
}

void require_triangles(const objects::TriangleMesh& mesh, const std::string& name) {
  if (mesh.triangles.empty()) throw InputError(fmt::format("{}: the file holds no triangle", name));
}

objects::TriangleMesh read_mesh(const std::filesystem::path& path, Warnings* warnings) {
  constexpr std::size_t most_bytes = std::size_t{1} << 31;
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto read = extension == ".obj"   ? read_obj
                    : extension == ".stl" ? read_stl
                    : extension == ".ply" ? read_ply
                                          : nullptr;
  if (read == nullptr) {
    throw InputError(fmt::format("{}: the format of the mesh is unknown (extension {}). Known are .obj, .stl and .ply",
                                 path.string(), extension.empty() ? "missing" : in_quotes(extension)));
  }
  try {
    return read(read_file_bytes(path, most_bytes), path.string(), warnings);
  } catch (const std::bad_alloc&) {
    throw DeviceError(fmt::format("{}: the mesh does not fit into memory", path.string()));
  }
}

}  // namespace sandsim
