// A kinematic object of a scene, ready to be asked where it is at a time.
#pragma once

#include <string>

#include "solver/objects/motion.hpp"
#include "solver/objects/shape.hpp"
#include "solver/scene.hpp"

namespace sandsim::objects {

// ---- from the values of a scene; they have passed check() -----------------------------------------------------------
Vec3 vector(const std::array<double, 3>& values);
/// The identity without a rotation. Throws std::invalid_argument for lengths of 0.
Quaternion orientation(const std::optional<Rotation>& rotation);
/// A mesh is baked here unless that has been done before.
Shape make_shape(const ObjectShape& shape);
/// Box around a shape when its frame lies at `pose`; without baking meshes.
Bounds bounds(const ObjectShape& shape, const Pose& pose);
/// Metres a unit of the file.
double factor(const MeshShape& shape);
Motion make_motion(const KinematicObject& object);

class Object {
 public:
  /// `grid_spacing` [m] is the default of sample_spacing. Throws std::invalid_argument for what check() rejects.
  Object(const KinematicObject& object, double grid_spacing);

  const std::string& name() const { return name_; }
  Coupling coupling() const { return coupling_; }
  VerticalTransfer vertical() const { return vertical_; }
  double sample_spacing() const { return sample_spacing_; }  // [m]

  /// The object is there at this time [s]: from its start on, until just before its end.
  bool is_present(double time) const { return time >= start_ && time < end_; }
  double start() const { return start_; }  // [s]
  /// It neither moves nor comes nor goes after this time; -infinite if it is always there and at rest. [s]
  double changes_until() const { return changes_until_; }
  RigidState at(double time) const { return objects::at(motion_, time); }

  /// The shape in its own frame: a point of the scene is to_local(state.pose, point) there. The view lives as long as
  /// the object and does not move with it.
  ShapeView shape() const { return shape_.view(); }
  /// Box in the scene around the object in a state.
  Bounds bounds(const RigidState& state) const { return shape_.bounds(state.pose); }
  /// No point of the object is faster. [m/s]
  double top_speed(const RigidState& state) const;

 private:
  std::string name_;
  Shape shape_;
  Motion motion_;
  Coupling coupling_;
  VerticalTransfer vertical_;
  double sample_spacing_;  // [m]
  double start_;           // [s]
  double end_;             // [s]
  double changes_until_;   // [s]
  double reach_;           // [m] of the shape's points from the origin of its frame
};

/// The parts inside the object of the vertical line through (x, y), between two heights [m]: intervals of z.
SANDSIM_HD Intervals inside_column(const ShapeView& shape, const Pose& pose, double x, double y,
                                   const Interval& heights, double sample_spacing) {
  const Line line{to_local(pose, {x, y, 0.0}), rotate(inverse(pose.orientation), {0.0, 0.0, 1.0})};
  return inside(shape, line, heights, sample_spacing);
}

}  // namespace sandsim::objects
