// The format of scene files for editors and other programs.
#pragma once

#include <string>

namespace sandsim {

/// The JSON Schema (draft-07) of the scene format. It knows keys, types, words, the form of quantities and the bounds
/// of pure numbers; bounds of quantities and rules across values are in its descriptions or not in it.
std::string json_schema();

}  // namespace sandsim
