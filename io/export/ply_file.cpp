#include <fmt/format.h>

#include <cstdint>
#include <cstdlib>

#include "io/export/bytes.hpp"
#include "io/export/mesh_files.hpp"
#include "solver/errors.hpp"

namespace sandsim {

namespace {

/// Integers up to here are exact in float64.
constexpr std::int64_t largest_exact = std::int64_t{1} << 53;

}  // namespace

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
      "property double x\nproperty double y\nproperty double z\nproperty double id\nend_header\n",
      particles.positions.size());
  for (std::size_t k = 0; k < particles.positions.size(); ++k) {
    const std::int64_t id = particles.ids[k];
    if (std::abs(id) > largest_exact) {
      throw OutputError(fmt::format("PLY has no integers that hold the id {} of a particle. Use --format vtp", id));
    }
    append_bytes(bytes, particles.positions[k]);
    append_bytes(bytes, static_cast<double>(id));
  }
  return bytes;
}

}  // namespace sandsim
