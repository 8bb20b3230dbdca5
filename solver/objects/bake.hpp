// Meshes into sampled signed distances.
#pragma once

#include <functional>

#include "solver/objects/distance_grid.hpp"
#include "solver/objects/mesh.hpp"

namespace sandsim::objects {

/// Samples of the longest side, the margin included.
inline constexpr int least_resolution = 16;
inline constexpr int most_resolution = 512;

/// Distance of the samples, in units of the mesh.
double sample_spacing(const TriangleMesh& mesh, int resolution);

struct BakedMesh {
  DistanceGrid grid;
  MeshDefects defects;
};

/// Signed distances on a grid of `resolution` points along the mesh's longest side, which reaches two spacings beyond
/// the mesh. Samples are the distances to the surface, to 5e-4 of themselves; their signs those of the winding number.
/// On a mesh that is not closed, holes are taken as closed where half of the view is blocked. `progress` is told the
/// finished fraction now and then. Throws std::invalid_argument for a resolution out of bounds or a mesh without a
/// triangle that has an area. The same bits for any number of threads.
BakedMesh bake(const TriangleMesh& mesh, int resolution, const std::function<void(double)>& progress = {});

}  // namespace sandsim::objects
