#include "io/scene/resolved_scene.hpp"

#include "io/scene/map_writer.hpp"
#include "io/scene/parameters.hpp"

namespace sandsim {

std::string resolved_scene(const Scene& scene, const std::filesystem::path& directory) {
  Scene copy = scene;  // the table is walked through with members that may be written to
  MapWriter writer("", directory);
  describe(writer, copy);
  return writer.lines();
}

}  // namespace sandsim
