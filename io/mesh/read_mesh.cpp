#include "io/mesh/read_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <new>

#include "io/mesh/faces.hpp"
#include "io/raster/source_text.hpp"
#include "solver/errors.hpp"

namespace sandsim {

void add_polygon(objects::TriangleMesh& mesh, const std::vector<std::uint32_t>& corners) {
  for (std::size_t k = 2; k < corners.size(); ++k) {
    mesh.triangles.push_back({corners[0], corners[k - 1], corners[k]});
  }
}

void require_triangles(const objects::TriangleMesh& mesh, const std::string& name) {
  if (mesh.triangles.empty()) throw InputError(fmt::format("{}: the file holds no triangle", name));
}

objects::TriangleMesh read_mesh(const std::filesystem::path& path) {
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
    return read(read_file_bytes(path, most_bytes), path.string());
  } catch (const std::bad_alloc&) {
    throw DeviceError(fmt::format("{}: the mesh does not fit into memory", path.string()));
  }
}

}  // namespace sandsim
