#include "io/output/series_layout.hpp"

#include <algorithm>

namespace sandsim {
namespace {

using enum Dimension;
using enum NumberType;

void add_fields(std::vector<Variable>& variables, const Output& output) {
  const auto wanted = [&output](OutputField field) {
    return std::find(output.fields.begin(), output.fields.end(), field) != output.fields.end();
  };
  const std::vector<Dimension> frames{time, y, x};
  if (wanted(OutputField::depth)) variables.push_back({"depth", frames, "m", "depth of the sand, vertical", real});
  if (wanted(OutputField::velocity)) {
    variables.push_back({"velocity_x", frames, "m/s", "velocity along x, mean over the depth", real});
    variables.push_back({"velocity_y", frames, "m/s", "velocity along y, mean over the depth", real});
  }
  if (wanted(OutputField::surface)) variables.push_back({"surface", frames, "m", "elevation of the surface", real});
  if (wanted(OutputField::momentum)) {
    variables.push_back({"momentum_x", frames, "m^2/s", "depth times velocity along x", real});
    variables.push_back({"momentum_y", frames, "m^2/s", "depth times velocity along y", real});
  }
}

void add_frame_numbers(std::vector<Variable>& variables) {
  variables.push_back({"volume", {time}, "m^3", "volume of the sand", float64});
  variables.push_back({"kinetic_energy", {time}, "m^5/s^2", "kinetic energy over the density", float64});
  variables.push_back({"max_speed", {time}, "m/s", "largest speed of any cell in the frame", float64});
  variables.push_back({"time_step_min", {time}, "s", "shortest time step since the last frame", float64});
  variables.push_back({"time_step_max", {time}, "s", "longest time step since the last frame", float64});
  variables.push_back({"steps", {time}, "1", "time steps since the start of the run", int64});
  variables.push_back({"wall_time", {time}, "s", "wall-clock time since the start of the run", float64});
  variables.push_back({"moving_cells", {time}, "1", "cells with momentum", int64});
}

void add_probes(std::vector<Variable>& variables) {
  variables.push_back({"probe", {probe}, "1", "number of the probe", int64});
  variables.push_back({"probe_name", {probe}, "", "name of the probe", text});
  variables.push_back({"probe_x", {probe}, "m", "x of the probe", float64});
  variables.push_back({"probe_y", {probe}, "m", "y of the probe", float64});
  variables.push_back({"probe_depth", {time, probe}, "m", "depth of the sand at the probe", float64});
  variables.push_back({"probe_velocity_x", {time, probe}, "m/s", "velocity along x at the probe", float64});
  variables.push_back({"probe_velocity_y", {time, probe}, "m/s", "velocity along y at the probe", float64});
}

void add_reference(std::vector<Variable>& variables, const Reference& reference) {
  if (!reference.front_depths.empty()) {
    variables.push_back({"front_depth", {front_depth}, "m", "depth that defines the front", float64});
    variables.push_back({"front", {time, front_depth}, "m", "largest x with more than front_depth of sand", float64});
  }
  if (reference.exact) {
    variables.push_back({"reference_depth", {time, x}, "m", "depth of the exact solution where it is valid", float64});
    variables.push_back({"reference_tip", {time}, "m", "tip of the exact solution", float64});
  }
}

void add_objects(std::vector<Variable>& variables) {
  variables.push_back({"object", {object}, "1", "number of the object", int64});
  variables.push_back({"quaternion", {quaternion}, "", "", nothing});
  variables.push_back({"object_name", {object}, "", "name of the object", text});
  variables.push_back({"object_position", {time, object, axis}, "m", "origin of the object's own frame", float64});
  variables.push_back(
      {"object_rotation", {time, object, quaternion}, "1", "rotation of its frame, w x y z: scene = R own", float64});
  variables.push_back({"object_present", {time, object}, "1", "whether the object is there", int64});
}

void add_particles(std::vector<Variable>& variables) {
  variables.push_back({"particle", {particle}, "", "", nothing});
  variables.push_back({"particle_position", {time, particle, axis}, "m", "place under the surface", float64});
  variables.push_back({"particle_id", {time, particle}, "1", "stays with a particle as long as it lives", int64});
  variables.push_back({"particle_visible", {time, particle}, "1", "whether it is in the sand", int8});
}

}  // namespace

bool Variable::coordinate() const {
  return dimensions.size() == 1 && name == name_of(dimensions.front());
}

std::string name_of(Dimension dimension) {
  switch (dimension) {
    case time:
      return "time";
    case y:
      return "y";
    case x:
      return "x";
    case probe:
      return "probe";
    case front_depth:
      return "front_depth";
    case object:
      return "object";
    case particle:
      return "particle";
    case axis:
      return "axis";
    case quaternion:
      return "quaternion";
  }
  return {};
}

std::size_t coupled_object_count(const Scene& scene) {
  return static_cast<std::size_t>(std::count_if(scene.objects.begin(), scene.objects.end(),
                                                [](const KinematicObject& each) { return !each.is_terrain(); }));
}

std::vector<Variable> series_layout(const Scene& scene) {
  std::vector<Variable> variables;
  variables.push_back({"time", {time}, "s", "time since the release", float64});
  variables.push_back({"y", {y}, "m", "y of the cell centres", float64});
  variables.push_back({"x", {x}, "m", "x of the cell centres", float64});
  // CF: what fields name by their attribute grid_mapping.
  if (scene.grid.crs.known()) variables.push_back({grid_mapping_name, {}, "", "coordinate reference system", int64});
  if (scene.output.frames) {
    variables.push_back({"bed", {y, x}, "m", "elevation of the bed", real});
    add_fields(variables, scene.output);
  }
  if (scene.output.maxima) {
    variables.push_back({"max_depth", {y, x}, "m", "largest depth of the run", real});
    const std::string above = "; in sand deeper than runout.above of run.json";
    variables.push_back({"max_speed_over_time", {y, x}, "m/s", "largest speed of the run" + above, real});
    variables.push_back({"arrival_time", {y, x}, "s", "time at which sand arrived, NaN: never" + above, real});
    if (scene.output.maxima->pressure) {
      variables.push_back(
          {"max_pressure", {y, x}, "Pa", "largest dynamic pressure of the run, density times speed^2" + above, real});
    }
  }
  add_frame_numbers(variables);
  if (!scene.output.probes.empty()) add_probes(variables);
  const bool has_objects = coupled_object_count(scene) > 0;
  if (has_objects || scene.particles) variables.push_back({"axis", {axis}, "", "", nothing});
  if (has_objects) add_objects(variables);
  if (scene.particles) add_particles(variables);
  if (scene.reference) add_reference(variables, *scene.reference);
  return variables;
}

}  // namespace sandsim
