// Triangle meshes: what may be wrong with them, and how much of it can be put right.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solver/objects/bounds.hpp"

namespace sandsim::objects {

/// Counterclockwise triangles when looked at from outside.
struct TriangleMesh {
  std::vector<Vec3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;  // indices of vertices, in range
};

/// The box around all vertices that triangles use.
Bounds bounds(const TriangleMesh& mesh);
/// Whether some triangle has an area: only then there is a surface.
bool has_area(const TriangleMesh& mesh);

/// What is not as in a closed surface. Vertices at the same coordinates count as one.
struct MeshDefects {
  std::size_t open_edges = 0;            // with one triangle
  std::size_t non_manifold_edges = 0;    // with more than two
  std::size_t flipped_triangles = 0;     // that looked inwards; turned round
  std::size_t degenerate_triangles = 0;  // with two corners at one place; left out

  bool is_closed() const { return open_edges == 0 && non_manifold_edges == 0; }
};

/// The volume inside a closed mesh, negative if its triangles look inwards. [m^3] or the cube of the file's unit
double signed_volume(const TriangleMesh& mesh);
double surface_area(const TriangleMesh& mesh);

/// A mesh whose vertices are welded and whose triangles are consistently turned where edges join two of them, and look
/// outwards where they close in a volume. A closed part inside another one is turned together with it: what was a
/// cavity stays one. Parts that are not closed are turned together, if what they nearly close in is negative.
struct RepairedMesh {
  TriangleMesh mesh;
  MeshDefects defects;
};
RepairedMesh repair(const TriangleMesh& mesh);

}  // namespace sandsim::objects
