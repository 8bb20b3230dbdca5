// `--set a.b=value`: changes to a scene's tree before it is read.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "io/scene/node.hpp"
#include "io/scene/problems.hpp"

namespace sandsim {

/// A change, and where it was written.
struct Override {
  std::string text;   // "a.b=value"
  std::string place;  // for messages: "--set a.b=value", or "study.yaml:3:9"
};

/// The values of `--set` options.
std::vector<Override> command_line_overrides(std::span<const std::string> texts);

/// Replaces, adds or removes ("a.b=") the values that `overrides` name, in order. A number in a path counts the
/// entries of a list from 0; one past the end appends, and 0 is also the map that stands for a list of one.
void apply_overrides(Node& root, std::span<const Override> overrides, Problems& problems);

}  // namespace sandsim
