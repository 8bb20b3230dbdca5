// The scene reader on any text: it gives a scene or an error of ours, and a scene resolves to itself.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "io/scene/resolved_scene.hpp"
#include "io/scene/scene_reader.hpp"
#include "solver/errors.hpp"

using namespace sandsim;

/// The text up to a byte 0xFF is the scene, what follows is the value of one `--set`.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string text(reinterpret_cast<const char*>(data), size);
  std::vector<std::string> overrides;
  if (const std::size_t end = text.find('\xFF'); end != std::string::npos) {
    overrides.push_back(text.substr(end + 1));
    text.resize(end);
  }
  std::string resolved;
  try {
    std::vector<std::string> warnings;
    resolved = resolved_scene(read_scene_text(text, "fuzz", "/nonexistent", overrides, &warnings));
  } catch (const SceneError&) {
    return 0;
  } catch (const InputError&) {
    return 0;
  }
  // Problems here are defects: they are thrown out of the target, or end it.
  if (resolved_scene(read_scene_text(resolved, "resolved", "/nonexistent")) != resolved) std::abort();
  return 0;
}
