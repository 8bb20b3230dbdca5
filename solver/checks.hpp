// Rules across the values of a scene; those of single values are in the reader's table.
#pragma once

#include <string>
#include <vector>

#include "solver/scene.hpp"

namespace sandsim {

/// One broken rule.
struct Issue {
  std::string key;  // path of the value to change, e.g. "sand.initial.0.depth"
  std::string problem;
  std::string why;                  // may be empty
  std::string suggestion;           // may be empty
  std::vector<std::string> uses{};  // other keys that the rule looked at: meaningless while one of these is wrong
};

/// All broken rules of a scene; empty if it can be run.
std::vector<Issue> check(const Scene& scene);

}  // namespace sandsim
