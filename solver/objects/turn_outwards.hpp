// Which side of a mesh is its outside.
#pragma once

#include <cstdint>
#include <vector>

#include "solver/objects/mesh.hpp"

namespace sandsim::objects {

/// Turns whole parts of a welded mesh so that they look outwards (see RepairedMesh). `pieces` holds, for each triangle,
/// the connected piece that it belongs to, counted from 0; the triangles of a piece agree with each other.
void turn_outwards(TriangleMesh& mesh, const std::vector<std::uint32_t>& pieces);

}  // namespace sandsim::objects
