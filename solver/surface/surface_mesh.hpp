// Triangle meshes of a height field: the surface of the sand, clipped where it is thin, and the terrain.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solver/objects/mesh.hpp"
#include "solver/surface/height_field.hpp"

namespace sandsim::surface {

/// Triangles run counterclockwise when looked at from above, or for a closed mesh from outside.
struct SurfaceMesh {
  objects::TriangleMesh shape;
  std::vector<std::array<float, 3>> normals;  // [-] unit, of each vertex
  std::vector<double> bed;                    // [m] elevation of the ground below each vertex
  /// Edges of one triangle only, with the mesh on their left; none in a closed mesh.
  std::vector<std::array<std::uint32_t, 2>> rim;
  std::size_t contour_edges = 0;  // of the rim; the others lie on the domain's sides
};

/// The surface where the depth exceeds `contour` [m, above 0]: "2-D marching cubes for an iso-value of h = 0.1 dL" (the
/// paper, section 7.2). Squares between four nodes are cut at the contour (marching squares; where two opposite
/// corners exceed it, they are joined if the mean of all four does). Points of the contour lie on sides of squares,
/// where depth and elevation are linear, and belong to both squares. They keep 1/256 of a side away from its ends, so
/// that no triangle is degenerate. Along the sides of the domain the mesh ends there.
SurfaceMesh sand_mesh(const HeightField& field, double contour);

/// The bed as a mesh, to the sides of the domain.
SurfaceMesh terrain_mesh(const Grid& grid, std::span<const double> bed);

/// Adds the ground below the mesh, looking down, and upright sides along the rim: a closed surface around the sand.
/// Vertices of the rim keep the normal of the surface.
void close(SurfaceMesh& mesh);

/// Volume between a mesh that is not closed and the ground. [m^3]
double volume_above_bed(const SurfaceMesh& mesh);

}  // namespace sandsim::surface
