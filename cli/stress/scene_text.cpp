#include <fmt/format.h>

#include "cli/stress/stress_case.hpp"

namespace sandsim::cli {

std::string SceneText::text(const std::string& title) const {
  std::string lines = fmt::format("title: \"{}\"\ngrid: {}\ngravity: {}\nterrain: {}\n", title, grid, gravity, terrain);
  lines += fmt::format("sand:\n  {}\n  hbar: {}\n", friction, hbar);
  if (!initial.empty()) {
    lines += fmt::format("  initial: {}\n", initial);
  }
  if (!sources.empty()) {
    lines += fmt::format("  sources: {}\n", sources);
  }
  if (!boundaries.empty()) {
    lines += fmt::format("boundaries: {}\n", boundaries);
  }
  lines +=
      fmt::format("time: {{end: {} s, frame_interval: {} s{}{}}}\n", end, end / frames, time.empty() ? "" : ", ", time);
  if (!objects.empty()) {
    lines += fmt::format("objects: {}\n", objects);
  }
  return lines;
}

}  // namespace sandsim::cli
