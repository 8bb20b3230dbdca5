// What `sandsim check` says of a scene's objects.
#pragma once

#include <string>

#include "solver/scene.hpp"

namespace sandsim::cli {

/// A line for each object: where it is at its start, its volume, and how many cells see it. Empty without objects.
std::string object_lines(const Scene& scene);

}  // namespace sandsim::cli
