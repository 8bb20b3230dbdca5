#include "solver/checks_objects.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <variant>

#include "solver/grid_problems.hpp"
#include "solver/objects/distance_grid.hpp"
#include "solver/objects/inspection.hpp"
#include "solver/objects/mesh.hpp"
#include "solver/objects/object.hpp"

namespace sandsim {

namespace {

using Issues = std::vector<Issue>;

template <std::size_t N>
bool is_zero(const std::array<double, N>& values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return value == 0.0; });
}

// The reader has complained about a file or a list without which these are false.
bool is_read(const MeshFile& file) {
  return file.mesh && !file.mesh->triangles.empty();
}
bool is_read(const SdfFile& file) {
  return file.distance && !file.distance->values.empty();
}
bool is_read(const ObjectShape& shape) {
  if (const auto* mesh = std::get_if<MeshShape>(&shape)) return is_read(mesh->file);
  if (const auto* sdf = std::get_if<SdfShape>(&shape)) return is_read(sdf->file);
  return true;
}
bool is_read(const ObjectMotion& motion) {
  if (const auto* m = std::get_if<Keyframes>(&motion)) return !m->keyframes.empty();
  if (const auto* m = std::get_if<Path>(&motion)) return !m->file.time.empty();
  if (const auto* m = std::get_if<Stroke>(&motion)) return !m->points.empty();
  return true;
}

/// Lengths far beyond those of sand: their squares and cubes could overflow. [m]
bool is_reasonable(double length) {
  return length > 1e-9 && length < 1e9;
}

void check_rotation(const std::string& key, const std::optional<Rotation>& rotation, Issues& issues) {
  if (!rotation) return;
  const int ways = (rotation->axis ? 1 : 0) + (rotation->quaternion ? 1 : 0) + (rotation->euler ? 1 : 0);
  const std::vector<std::string> uses{key + ".axis", key + ".quaternion", key + ".euler", key + ".angle"};
  if (ways != 1) {
    issues.push_back({key, ways == 0 ? "no rotation is given" : "more than one rotation is given",
                      "exactly one of axis, quaternion and euler is needed",
                      "Write it like {axis: [0, 0, 1], angle: 30 deg}.", uses});
  } else if (rotation->axis.has_value() != rotation->angle.has_value()) {
    issues.push_back({key + ".angle", rotation->angle ? "not used" : "missing", "an axis and an angle belong together",
                      rotation->angle ? "Remove it." : "Add \"angle: 30 deg\".", uses});
  } else if (rotation->quaternion && is_zero(*rotation->quaternion)) {
    issues.push_back(
        {key + ".quaternion", "its length is 0", "it is then no rotation", "No rotation is [1, 0, 0, 0].", {}});
  } else if (rotation->axis && is_zero(*rotation->axis)) {
    issues.push_back({key + ".axis", "its length is 0", "it then has no direction", "z is [0, 0, 1].", {}});
  }
}

/// The rules of a shape; `key` is its path.
struct ShapeChecks {
  std::string key;
  Issues& issues;

  template <class T>
  void operator()(const T& shape) const {
    check_rotation(key + ".rotation", shape.placement.rotation, issues);
    check_own(shape);
  }

  template <class T>
  void check_own(const T&) const {}
  void check_own(const CapsuleShape& capsule) const {
    if (capsule.length >= 2.0 * capsule.radius) return;
    issues.push_back({key + ".length",
                      "shorter than its caps",
                      "two half spheres are " + number_text(2.0 * capsule.radius) + " m long",
                      "A sphere is {type: sphere, radius: ...}.",
                      {key + ".radius"}});
  }
  void check_own(const HalfSpaceShape& half_space) const {
    if (!is_zero(half_space.normal)) return;
    issues.push_back({key + ".normal", "its length is 0", "it then has no direction", "Up is [0, 0, 1].", {}});
  }
  void check_own(const CsgShape& csg) const {
    if (csg.parts.size() < 2 || csg.parts.size() > objects::most_primitives) {
      issues.push_back({key + ".parts",
                        "a set operation takes 2 to 16 parts",
                        "these are " + std::to_string(csg.parts.size()),
                        "",
                        {}});
    }
    for (std::size_t k = 0; k < csg.parts.size(); ++k) {
      std::visit(ShapeChecks{key + ".parts." + std::to_string(k), issues}, csg.parts[k]);
    }
  }

  void check_own(const MeshShape& shape) const {
    if (!is_read(shape.file)) return;
    const objects::TriangleMesh& mesh = *shape.file.mesh;
    const objects::Vec3 size = objects::bounds(mesh).high - objects::bounds(mesh).low;
    const double side = std::max({size.x, size.y, size.z});
    if (!objects::has_area(mesh)) {
      issues.push_back({key + ".file", "the mesh is no surface", "none of its triangles has an area", "", {}});
    } else if (!is_reasonable(side) || !is_reasonable(side * objects::factor(shape))) {
      issues.push_back({key + ".file",
                        "the mesh is too small or too large",
                        "its longest side is " + number_text(side) + " in the file and " +
                            number_text(side * objects::factor(shape)) + " m in the scene",
                        "Set unit and scale.",
                        {key + ".unit", key + ".scale"}});
    }
  }
  void check_own(const SdfShape& sdf) const {
    if (!is_read(sdf.file)) return;
    const bool knows_place = sdf.file.distance->spacing > 0.0;
    for (const auto& [name, is_given] :
         {std::pair{".spacing", sdf.spacing.has_value()}, std::pair{".origin", sdf.origin.has_value()}}) {
      if (knows_place != is_given) continue;
      issues.push_back({key + name,
                        is_given ? "not used" : "missing",
                        is_given ? "the file knows it" : "an array does not know it",
                        is_given ? "Remove it." : "",
                        {key + ".file"}});
    }
    const double spacing = sdf.spacing.value_or(sdf.file.distance->spacing);
    if (spacing > 0.0 && !(is_reasonable(spacing) && is_reasonable(sdf.scale) && is_reasonable(spacing * sdf.scale))) {
      issues.push_back({key + ".scale",
                        "the samples are too near or too far apart",
                        "their distance is " + number_text(spacing * sdf.scale) + " m",
                        "",
                        {key + ".spacing"}});
    }
  }
};

void check_ascending(const std::string& list, const std::vector<double>& times, Issues& issues) {
  for (std::size_t k = 1; k < times.size(); ++k) {
    if (times[k] > times[k - 1]) continue;
    const std::string key = list + '.' + std::to_string(k) + ".time";
    const std::string before = list + '.' + std::to_string(k - 1) + ".time";
    issues.push_back({key,
                      "not after the time before it",
                      "that is " + number_text(times[k - 1]) + " s",
                      "Sort them by time.",
                      {before}});
  }
}

/// The rules of a motion; `key` is its path.
struct MotionChecks {
  std::string key;
  Issues& issues;

  void operator()(const FixedMotion&) const {}
  void operator()(const ConstantMotion&) const {}
  void operator()(const Path&) const {}
  void operator()(const Spin& spin) const {
    if (!is_zero(spin.axis)) return;
    issues.push_back({key + ".axis", "its length is 0", "it then has no direction", "z is [0, 0, 1].", {}});
  }
  void operator()(const Keyframes& motion) const {
    std::vector<double> times;
    for (const ObjectKeyframe& k : motion.keyframes) {
      check_rotation(key + ".keyframes." + std::to_string(times.size()) + ".rotation", k.rotation, issues);
      times.push_back(k.time);
    }
    check_ascending(key + ".keyframes", times, issues);
  }
  void operator()(const Stroke& stroke) const {
    std::vector<double> times;
    for (const StrokePoint& p : stroke.points) times.push_back(p.time);
    check_ascending(key + ".points", times, issues);
  }
};

void check_times(const Scene& scene, const KinematicObject& object, const std::string& key, Issues& issues) {
  if (object.end && *object.end <= object.start) {
    issues.push_back({key + ".end",
                      "the object ends before it starts",
                      "it starts at " + number_text(object.start) + " s",
                      "",
                      {key + ".start"}});
  } else if (object.start >= scene.time.end) {
    issues.push_back({key + ".start",
                      "the object starts after the end of the run",
                      "time.end is " + number_text(scene.time.end) + " s",
                      "",
                      {"time.end"}});
  }
}

/// An object that nothing else is wrong with has to start over the grid: what is far off is a slip in its numbers.
void check_place(const Scene& scene, const KinematicObject& object, const std::string& key, Issues& issues) {
  const objects::Bounds box =
      objects::bounds(object.shape, objects::at(objects::make_motion(object), object.start).pose);
  if (box.empty()) {
    issues.push_back({key + ".shape",
                      "nothing is inside",
                      std::holds_alternative<CsgShape>(object.shape) ? "the set operation leaves no volume"
                                                                     : "no sample is negative",
                      "",
                      {key}});
    return;
  }
  const Grid& grid = scene.grid;
  const double right = grid.origin[0] + grid.cells[0] * grid.spacing;
  const double top = grid.origin[1] + grid.cells[1] * grid.spacing;
  const bool meets_x = box.low.x < right && box.high.x > grid.origin[0];
  const bool meets_y = grid.one_dimensional() || (box.low.y < top && box.high.y > grid.origin[1]);
  if (meets_x && meets_y) return;
  std::string why = "it spans x from " + number_text(box.low.x) + " m to " + number_text(box.high.x) + " m";
  if (!grid.one_dimensional()) {
    why += " and y from " + number_text(box.low.y) + " m to " + number_text(box.high.y) + " m";
  }
  issues.push_back({key, "starts outside the grid", why + "; " + grid_text(grid), "", {"grid"}});
}

/// The top of an object that is part of the terrain becomes the ground.
void check_terrain(const KinematicObject& object, const std::string& key, Issues& issues) {
  if (object.is_terrain() && std::holds_alternative<HalfSpaceShape>(object.shape)) {
    issues.push_back({key + ".shape",
                      "a solid object that stands still cannot be endless",
                      "its top becomes the ground",
                      "Take a box, or a terrain of type plane.",
                      {}});
  }
}

/// An object that never moves has to cover the centre of a cell: the cells see nothing else of it.
void check_coverage(const Scene& scene, const KinematicObject& object, const std::string& key, Issues& issues) {
  if (!std::holds_alternative<FixedMotion>(object.motion) || objects::covered_cells(object, scene.grid, 1) > 0) return;
  issues.push_back({key,
                    "it covers no centre of a cell and so does nothing",
                    "it is " + number_text(objects::narrowest_width(object, scene.grid)) +
                        " m wide at its narrowest and the cells " + number_text(scene.grid.spacing) + " m",
                    std::string("Make it wider than a cell, move it onto the centres of cells, or make grid.spacing ") +
                        (std::holds_alternative<SdfShape>(object.shape) ? "or sample_spacing finer." : "finer."),
                    {"grid"}});
}

void check_object(const Scene& scene, const KinematicObject& object, const std::string& key, Issues& issues) {
  const std::size_t before = issues.size();
  std::visit(ShapeChecks{key + ".shape", issues}, object.shape);
  std::visit(MotionChecks{key + ".motion", issues}, object.motion);
  check_rotation(key + ".rotation", object.rotation, issues);
  check_times(scene, object, key, issues);
  check_terrain(object, key, issues);
  if (issues.size() > before || !is_read(object.shape) || !is_read(object.motion)) return;
  check_place(scene, object, key, issues);
  if (issues.size() == before) check_coverage(scene, object, key, issues);
}

}  // namespace

void check_objects(const Scene& scene, Issues& issues) {
  std::set<std::string> names;
  for (std::size_t k = 0; k < scene.objects.size(); ++k) {
    const KinematicObject& object = scene.objects[k];
    const std::string key = "objects." + std::to_string(k);
    if (!names.insert(object.name).second) {
      issues.push_back({key + ".name", "another object has this name", "objects are told apart by it", "", {}});
    }
    check_object(scene, object, key, issues);
  }
}

}  // namespace sandsim
