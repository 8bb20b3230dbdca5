#include "solver/checks_objects.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <variant>

#include "solver/grid_problems.hpp"
#include "solver/objects/object.hpp"

namespace sandsim {

namespace {

using Issues = std::vector<Issue>;

template <std::size_t N>
bool is_zero(const std::array<double, N>& values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return value == 0.0; });
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

/// False while the reader has complained about a list or table that is empty.
bool has_positions(const ObjectMotion& motion) {
  if (const auto* m = std::get_if<Keyframes>(&motion)) return !m->keyframes.empty();
  if (const auto* m = std::get_if<Path>(&motion)) return !m->file.time.empty();
  if (const auto* m = std::get_if<Stroke>(&motion)) return !m->points.empty();
  return true;
}

/// An object that nothing else is wrong with has to start over the grid: what is far off is a slip in its numbers.
void check_place(const Scene& scene, const KinematicObject& object, const std::string& key, Issues& issues) {
  const objects::Bounds box =
      objects::make_shape(object.shape).bounds(objects::at(objects::make_motion(object), object.start).pose);
  if (box.empty()) {
    issues.push_back({key + ".shape", "nothing is inside", "the set operation leaves no volume", "", {key}});
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

void check_object(const Scene& scene, const KinematicObject& object, const std::string& key, Issues& issues) {
  const std::size_t before = issues.size();
  std::visit(ShapeChecks{key + ".shape", issues}, object.shape);
  std::visit(MotionChecks{key + ".motion", issues}, object.motion);
  check_rotation(key + ".rotation", object.rotation, issues);
  check_times(scene, object, key, issues);
  if (issues.size() == before && has_positions(object.motion)) check_place(scene, object, key, issues);
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
