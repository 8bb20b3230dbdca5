// The sand as a sampled signed distance, for renderers and as an object of another scene.
#pragma once

#include "solver/objects/distance_grid.hpp"
#include "solver/surface/surface_mesh.hpp"

namespace sandsim::surface {

/// How a level set is sampled.
struct LevelSetGrid {
  double spacing = 0.0;  // [m] of the samples
  double band = 0.0;     // [m] distances beyond it are cut off, on both sides
};

/// The grid about the sand under a mesh that is not closed: it reaches one sample beyond the band on all sides. About
/// no sand there are two samples along each axis. Without values.
objects::DistanceGrid level_set_grid(const SurfaceMesh& mesh, const LevelSetGrid& sampling);

/// Samples the distance to the closed surface around the sand (see close()), negative within. Distances are those to
/// the mesh, to 5e-4 of themselves (TriangleTree), up to the band; signs tell whether a sample lies between the mesh
/// and the ground. The same bits for any number of threads.
objects::DistanceGrid level_set(SurfaceMesh mesh, const LevelSetGrid& sampling);

}  // namespace sandsim::surface
