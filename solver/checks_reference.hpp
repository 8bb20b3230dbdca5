// Rules for the references of a scene: whether they can say anything about it.
#pragma once

#include <vector>

#include "solver/checks.hpp"

namespace sandsim {

/// Adds the broken rules of scene.reference, which has to be there.
void check_reference(const Scene& scene, std::vector<Issue>& issues);

}  // namespace sandsim
