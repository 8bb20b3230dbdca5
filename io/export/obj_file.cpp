#include <fmt/format.h>

#include <iterator>

#include "io/export/mesh_files.hpp"

namespace sandsim {

std::string obj_text(const surface::SurfaceMesh& mesh) {
  std::string text = "# sandsim, metres, z up\n";
  auto out = std::back_inserter(text);
  for (const objects::Vec3& v : mesh.shape.vertices) fmt::format_to(out, "v {} {} {}\n", v.x, v.y, v.z);
  for (const auto& n : mesh.normals) fmt::format_to(out, "vn {} {} {}\n", n[0], n[1], n[2]);
  for (const auto& t : mesh.shape.triangles) {
    fmt::format_to(out, "f {0}//{0} {1}//{1} {2}//{2}\n", t[0] + 1, t[1] + 1, t[2] + 1);  // counted from 1
  }
  return text;
}

}  // namespace sandsim
