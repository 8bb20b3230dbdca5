// `--set a.b=value`: changes to a scene's tree before it is read.
#pragma once

#include <span>
#include <string>

#include "io/scene/node.hpp"
#include "io/scene/problems.hpp"

namespace sandsim {

/// Replaces, adds or removes ("a.b=") the values that `overrides` name, in order. A number in a path counts the
/// entries of a list from 0; one past the end appends, and 0 is also the map that stands for a list of one.
void apply_overrides(Node& root, std::span<const std::string> overrides, Problems& problems);

}  // namespace sandsim
