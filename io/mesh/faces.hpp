// What the readers of meshes share.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "solver/objects/mesh.hpp"

namespace sandsim {

/// Indices of vertices are 32 bits wide.
inline constexpr std::size_t most_vertices = std::size_t{1} << 31;

/// Adds a polygon as a fan of triangles about its first corner.
void add_polygon(objects::TriangleMesh& mesh, const std::vector<std::uint32_t>& corners);

/// Throws InputError if there is no triangle.
void require_triangles(const objects::TriangleMesh& mesh, const std::string& name);

}  // namespace sandsim
