// What the tests of surfaces share: small fields, and what holds of every mesh.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "solver/surface/surface_mesh.hpp"

namespace sandsim::test {

/// nx * ny cells of 1 m at the origin.
Grid unit_grid(int nx, int ny);

/// A height field of such cells on level ground at 0 m.
surface::HeightField flat_field(int nx, int ny, const std::vector<double>& depth);

/// A rough deposit: bumps of up to 3 m among cells without sand, the same for the same seed.
std::vector<double> rough_depth(int nx, int ny, unsigned seed);

/// How often each directed edge is used.
using Edges = std::map<std::pair<std::uint32_t, std::uint32_t>, int>;
Edges directed_edges(const objects::TriangleMesh& mesh);

/// Every directed edge occurs once, and edges without their opposite are exactly those of the rim.
bool is_manifold(const surface::SurfaceMesh& mesh);

/// Volume that a closed mesh encloses, by the divergence theorem. [m^3]
double enclosed_volume(const objects::TriangleMesh& mesh);

double smallest_area(const objects::TriangleMesh& mesh);
/// Seen from above. [m^2]
double projected_area(const objects::TriangleMesh& mesh);
/// No two vertices lie at the same coordinates, and triangles use all of them.
bool uses_each_vertex_once(const objects::TriangleMesh& mesh);

}  // namespace sandsim::test
