// A field on a fine grid as the means over the cells of a coarse one.
#pragma once

#include <span>
#include <vector>

#include "solver/scene.hpp"

namespace sandsim {

/// Means of `values` (ny * nx of `fine`, x fastest) over the cells of `coarse`, which covers the same domain. Fine
/// cells that lie in two coarse ones count by their parts, so that the integral over the domain is kept for any ratio
/// of the spacings. With one row only x counts.
std::vector<double> restrict_to(const Grid& coarse, const Grid& fine, std::span<const double> values);

}  // namespace sandsim
