// What can be told of a scene's objects before a run: how large they are, and whether the cells can see them.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "solver/checks.hpp"
#include "solver/scene.hpp"

namespace sandsim::objects {

/// Cells whose centre lies above or below a point of the object at its start. A mesh is looked at as it is in its file,
/// not as it is sampled. Stops at `most`.
std::size_t covered_cells(const KinematicObject& object, const Grid& grid,
                          std::size_t most = std::numeric_limits<std::size_t>::max());

/// Width of the object's footprint at its narrowest, at its start: that of the box around its shape in the shape's own
/// frame; of one row of cells, along x. [m]
double narrowest_width(const KinematicObject& object, const Grid& grid);

/// Volume of a shape, to about 1 % where it is not a mesh. Nothing for one that is endless or a mesh that is not
/// closed. [m^3]
std::optional<double> volume(const ObjectShape& shape);

/// Objects that cells or samples may miss: they run, but maybe not as meant. The scene has passed check().
std::vector<Issue> thin_objects(const Scene& scene);

}  // namespace sandsim::objects
