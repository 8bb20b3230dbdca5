// Checks that several commands put on their options.
#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "cli/text.hpp"

namespace sandsim::cli {

/// Accepts the given words only; CLI11's own check for this prints how it stores them.
inline std::function<std::string(const std::string&)> one_of(std::vector<std::string> words) {
  return [words](const std::string& text) -> std::string {
    const bool known = std::find(words.begin(), words.end(), text) != words.end();
    return known ? "" : "'" + text + "' is none of " + join(", ", words);
  };
}

}  // namespace sandsim::cli
