#include <fmt/format.h>

#include <cstdint>
#include <limits>

#include "io/export/bytes.hpp"
#include "io/export/mesh_files.hpp"
#include "solver/errors.hpp"

namespace sandsim {

std::string ply_bytes(const surface::SurfaceMesh& mesh) {
  const auto& [vertices, triangles] = mesh.shape;
  std::string bytes = fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment sandsim, metres, z up\nelement vertex {}\n"
      "property double x\nproperty double y\nproperty double z\n"
      "property float nx\nproperty float ny\nproperty float nz\n"
      "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
      vertices.size(), triangles.size());
  bytes.reserve(bytes.size() + 36 * vertices.size() + 13 * triangles.size());
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    append_bytes(bytes, vertices[v]);
    append_bytes(bytes, mesh.normals[v]);
  }
  for (const auto& triangle : triangles) {
    append_bytes(bytes, std::uint8_t{3});
    append_bytes(bytes, triangle);
  }
  return bytes;
}

std::string ply_bytes(const VisibleParticles& particles) {
  std::string bytes = fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment sandsim, metres, z up\nelement vertex {}\n"
      "property float x\nproperty float y\nproperty float z\nproperty int id\nend_header\n",
      particles.positions.size());
  for (std::size_t k = 0; k < particles.positions.size(); ++k) {
    const std::int64_t id = particles.ids[k];
    if (id < 0 || id > std::numeric_limits<std::int32_t>::max()) {
      throw OutputError(fmt::format("PLY has 32 bits for the id {} of a particle. Use --format vtp, which has 64", id));
    }
    append_bytes(bytes, particles.positions[k]);
    append_bytes(bytes, static_cast<std::int32_t>(id));
  }
  return bytes;
}

}  // namespace sandsim
