// The part of the table of parameters that describes kinematic objects; see parameters.hpp.
#pragma once

#include <variant>

#include "io/scene/names_objects.hpp"
#include "io/scene/rule.hpp"
#include "solver/objects/bake.hpp"
#include "solver/scene_objects.hpp"

namespace sandsim {

// ---- where things lie -----------------------------------------------------------------------------------------------
template <class V>
void describe(V& v, Rotation& r) {
  v.field("axis", r.axis, number().like("[0, 0, 1]"),
          "Axis to turn about, of any length; with an angle. Exactly one of axis, quaternion and euler is given.");
  v.field("angle", r.angle, angle(), "Angle about the axis, counterclockwise when looked at from its tip.");
  v.field("quaternion", r.quaternion, number().components({"w", "x", "y", "z"}).like("[1, 0, 0, 0]"),
          "Quaternion, of any length.");
  v.field("euler", r.euler, angle().like("[0 deg, 0 deg, 90 deg]"),
          "Roll about x, then pitch about y, then yaw about z; the axes do not turn along.");
}

template <class V>
void describe(V& v, Placement& p) {
  v.field("position", p.position, length(), "Where the shape lies in the frame of its object.");
  v.field("rotation", p.rotation, section(), "How it is turned in that frame.");
}

// ---- shapes ---------------------------------------------------------------------------------------------------------
template <class V>
void describe(V& v, SphereShape& s) {
  v.field("radius", s.radius, length().above(0).required().like("5 cm"), "Radius.");
  describe(v, s.placement);
}

template <class V>
void describe(V& v, BoxShape& s) {
  v.field("size", s.size, length().above(0).required().like("[10 cm, 20 cm, 5 cm]"), "Lengths of the sides.");
  describe(v, s.placement);
}

template <class V>
void describe(V& v, CapsuleShape& s) {
  v.field("radius", s.radius, length().above(0).required().like("2 cm"), "Radius.");
  v.field("length", s.length, length().above(0).required().like("10 cm"), "Length of the whole, caps included.");
  describe(v, s.placement);
}

template <class V>
void describe(V& v, CylinderShape& s) {
  v.field("radius", s.radius, length().above(0).required().like("5 cm"), "Radius.");
  v.field("height", s.height, length().above(0).required().like("20 cm"), "Height.");
  describe(v, s.placement);
}

template <class V>
void describe(V& v, ConeShape& s) {
  v.field("radius", s.radius, length().above(0).required().like("5 cm"), "Radius of the base.");
  v.field("height", s.height, length().above(0).required().like("10 cm"), "Height.");
  describe(v, s.placement);
}

template <class V>
void describe(V& v, EllipsoidShape& s) {
  v.field("radii", s.radii, length().above(0).required().like("[5 cm, 5 cm, 2 cm]"), "Radii along x, y and z.");
  describe(v, s.placement);
}

template <class V>
void describe(V& v, HalfSpaceShape& s) {
  v.field("normal", s.normal, number(), "Direction out of it, of any length.");
  describe(v, s.placement);
}

template <class V>
void describe(V& v, BrushShape& s) {
  v.field("radius", s.radius, length().above(0).required().like("1 cm"), "Radius.");
  v.field("height", s.height, length().above(0).required().like("20 cm"), "Height above the tip.");
  describe(v, s.placement);
}

template <class V>
void describe(V& v, CsgShape& s) {
  v.field("operation", s.operation, choice().required().like("difference"),
          "The union or the intersection of the parts; difference: the first part without the others.");
  v.field("parts", s.parts, list().required().not_empty().like("[{type: box, ...}, {type: sphere, ...}]"),
          "2 to 16 shapes, each with its own position.");
  describe(v, s.placement);
}

template <class V>
void describe(V& v, MeshShape& s) {
  v.field("file", s.file, file().required().like("car.obj"),
          "OBJ, STL or PLY; a relative name is relative to the scene file. Faces that look inwards are turned.");
  v.field("unit", s.unit, choice(), "Unit of the coordinates in the file.");
  v.field("scale", s.scale, number().above(0), "Factor on the coordinates.");
  v.field("resolution", s.resolution, number().at_least(objects::least_resolution).at_most(objects::most_resolution),
          "Samples of the signed distance along the longest side of the mesh.");
  describe(v, s.placement);
}

template <class V>
void describe(V& v, SdfShape& s) {
  v.field("file", s.file, file().required().like("car.sdf"),
          "SDFGen's .sdf, or .npy or .h5 (distance) with the dimensions z, y, x, negative inside; a relative name is "
          "relative to the scene file.");
  v.field("spacing", s.spacing, length().above(0).like("1 mm"),
          "Distance of the samples, if the file does not know it.");
  v.field("origin", s.origin, length().like("[0 m, 0 m, 0 m]"),
          "Place of the first sample, if the file does not know it.");
  v.field("scale", s.scale, number().above(0), "Factor on all lengths in the file.");
  describe(v, s.placement);
}

// ---- motions --------------------------------------------------------------------------------------------------------
template <class V>
void describe(V&, FixedMotion&) {}

template <class V>
void describe(V& v, ConstantMotion& m) {
  v.field("velocity", m.velocity, speed().like("[30 cm/s, 0 m/s, 0 m/s]"), "Velocity of the object's position.");
  v.field("angular_velocity", m.angular_velocity, angular_velocity().like("[0 rad/s, 0 rad/s, 90 deg/s]"),
          "Rotation about the object's position, right-handed about the axes of the scene.");
}

template <class V>
void describe(V& v, Spin& m) {
  v.field("axis", m.axis, number(), "Axis to turn about, of any length.");
  v.field("rate", m.rate, angular_velocity().required().like("60 rpm"),
          "Counterclockwise when looked at from the tip of the axis.");
  v.field("center", m.center, length().like("[50 cm, 50 cm, 0 m]"),
          "A point of the axis; without it, the object's position.");
}

template <class V>
void describe(V& v, ObjectKeyframe& k) {
  v.field("time", k.time, time_span().required().like("2 s"), "Simulated time.");
  v.field("position", k.position, length().required().like("[50 cm, 50 cm, 0 m]"), "Where the object then is.");
  v.field("rotation", k.rotation, section(), "How it is then turned.");
}

template <class V>
void describe(V& v, Keyframes& m) {
  v.field("interpolation", m.interpolation, choice(),
          "linear: even motion from one to the next, rotations by the shorter way. cubic: with continuous velocities.");
  v.field("keyframes", m.keyframes, list().required().not_empty().like("[{time: 0 s, position: ...}, ...]"),
          "Ascending in time. Before the first and after the last one the object rests.");
}

template <class V>
void describe(V& v, Path& m) {
  v.field("file", m.file, file().required().like("path.csv"), "CSV of time_s, x_m, y_m and z_m, ascending in time.");
  v.field("interpolation", m.interpolation, choice(), "Between the points, as between keyframes.");
}

template <class V>
void describe(V& v, StrokePoint& p) {
  v.field("time", p.time, time_span().required().like("2 s"), "Simulated time.");
  v.field("position", p.position, length().required().like("[50 cm, 50 cm, 0 m]"), "Where the object then is.");
}

template <class V>
void describe(V& v, Stroke& m) {
  v.field("points", m.points, list().required().not_empty().like("[{time: 0 s, position: ...}, ...]"),
          "Ascending in time; a z above the sand lifts the brush.");
}

// ---- the object -----------------------------------------------------------------------------------------------------
template <class V>
void describe(V& v, KinematicObject& o) {
  v.field("name", o.name, text().required().like("plough"), "Name in messages and in the report.");
  v.field("shape", o.shape, section().required().like("{type: sphere, radius: 5 cm}"), "What it looks like.");
  v.field("motion", o.motion, section(), "How it moves; without it, it is fixed.");
  const bool has_keyframes = std::holds_alternative<Keyframes>(o.motion);
  const bool has_positions =
      has_keyframes || std::holds_alternative<Path>(o.motion) || std::holds_alternative<Stroke>(o.motion);
  v.field("position", o.position, length().only(!has_positions, "motion: fixed, constant or spin"),
          "Where the origin of the shape's frame is at the start.");
  v.field("rotation", o.rotation, section().only(!has_keyframes, "motion: other than keyframes"),
          "How the object is turned at the start.");
  v.field("coupling", o.coupling, choice(),
          "displace: sand is moved out of its way. drag: sand takes on its velocity (section 5 of the paper). solid: "
          "no sand stays inside; standing still, it is part of the terrain.");
  v.field("vertical", o.vertical, choice().only(o.coupling == Coupling::drag, "coupling: drag"),
          "How vertical motion pushes sand sideways: eq. 23 per component, eq. 24 as printed, or not at all.");
  const bool is_sampled = std::holds_alternative<MeshShape>(o.shape) || std::holds_alternative<SdfShape>(o.shape);
  v.field("sample_spacing", o.sample_spacing, length().above(0).only(is_sampled, "shape: mesh or sdf"),
          "Distance of the samples along a column of sand; without it, the grid's spacing.");
  v.field("start", o.start, time_span().at_least(0), "The object is there from then on.");
  v.field("end", o.end, time_span().above(0), "And until then; without it, to the end of the run.");
}

}  // namespace sandsim
