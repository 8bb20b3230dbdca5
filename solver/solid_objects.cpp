#include "solver/solid_objects.hpp"

#include "solver/backends/coupling/job.hpp"
#include "solver/objects/object.hpp"

namespace sandsim {
namespace {

void raise(const Scene& scene, const objects::Object& object, InitialState& state) {
  const Grid& grid = scene.grid;
  const objects::RigidState place = object.at(object.start());
  const objects::ShapeView shape = object.shape();
  std::size_t cell = 0;
  for (int j = 0; j < grid.cells[1]; ++j) {
    for (int i = 0; i < grid.cells[0]; ++i, ++cell) {
      const objects::Intervals inside = objects::inside_column(
          shape, place.pose, grid.x(i), grid.y(j), {state.bed[cell], objects::endless}, object.sample_spacing());
      if (inside.count > 0 && inside.items[0].from - state.bed[cell] < coupling::least_gap * grid.spacing) {
        state.bed[cell] = inside.items[0].to;
        state.depth[cell] = 0.0;
      }
    }
  }
}

}  // namespace

void raise_solid_objects(const Scene& scene, InitialState& state) {
  for (const KinematicObject& object : scene.objects) {
    if (object.is_terrain()) {
      if (state.bed.empty()) {
        state.bed.assign(scene.grid.cell_count(), 0.0);
      }
      raise(scene, objects::Object(object, scene.grid.spacing), state);
    }
  }
}

}  // namespace sandsim
