// What the tests of the scene reader share.
#pragma once

#include <string>
#include <vector>

#include "io/scene/scene_reader.hpp"
#include "solver/errors.hpp"

namespace sandsim::test {

/// The shortest scene that can be run.
inline const std::string smallest_scene =
    "grid: {cells: [20, 1], spacing: 1 cm}\n"
    "sand: {friction_angle: 30 deg, initial: {type: layer, depth: 1 cm}}\n"
    "time: {end: 1 s, frame_interval: 10 ms}\n";

/// Reads text as the file "s.yaml" in the folder of the bad scenes.
inline Scene read(const std::string& text, const std::vector<std::string>& overrides = {},
                  std::vector<std::string>* warnings = nullptr) {
  return read_scene_text(text, "s.yaml", SANDSIM_SOURCE_DIR "/tests/bad_scenes", overrides, warnings);
}

/// What reading complains about; empty if it does not.
inline std::string complaints(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    read(text, overrides);
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

}  // namespace sandsim::test
