// The reference page of the scene format.
#pragma once

#include <string>

namespace sandsim {

/// Markdown: how values are written, then one table of keys for every map of a scene.
std::string format_reference();

}  // namespace sandsim
