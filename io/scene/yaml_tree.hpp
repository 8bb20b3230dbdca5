// YAML text into a tree of nodes, with the traps of the language closed.
#pragma once

#include <string>

#include "io/scene/node.hpp"
#include "io/scene/problems.hpp"

namespace sandsim {

/// The largest scene file: thousands of probes fit, and the parser, which needs up to 200 bytes and 2 us a byte of
/// hostile text, stays within reason. Fields of values belong into rasters.
inline constexpr std::size_t largest_scene_file = std::size_t{1} << 20;  // [bytes]

/// Parses one YAML document. Duplicate keys are added to `problems` and their first value is kept. Everything that
/// leaves no tree to go on with (syntax errors, several documents, tags, aliases that contain themselves or expand
/// without bound, depth over 64, keys that are not scalars, empty, binary or huge text) is added and thrown at once
/// (SceneError). `override_at` >= 0: the text is the value of that `--set`; it may then be empty (null).
Node parse_yaml(const std::string& text, Problems& problems, int override_at = -1);

}  // namespace sandsim
