// The rules of a scene's kinematic objects.
#pragma once

#include <vector>

#include "solver/checks.hpp"

namespace sandsim {

/// Adds the broken rules of `objects`.
void check_objects(const Scene& scene, std::vector<Issue>& issues);

}  // namespace sandsim
