// Options whose values have units.
#pragma once

#include <string>

#include "io/scene/quantity.hpp"

namespace sandsim::cli {

/// The value of `option` in SI units. `cell` is the grid's spacing [m] for lengths in cells, 0 where there is none.
/// Throws Error (usage) if `text` is no such quantity.
double quantity_option(const std::string& option, const std::string& text, Dimension dimension, double cell);

/// The same; throws also unless it is above 0.
double positive_option(const std::string& option, const std::string& text, Dimension dimension, double cell);

}  // namespace sandsim::cli
