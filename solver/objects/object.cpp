#include "solver/objects/object.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <variant>

#include "solver/objects/bake.hpp"
#include "solver/objects/distance_grid.hpp"
#include "solver/objects/mesh.hpp"
#include "solver/objects/rotation.hpp"

namespace sandsim::objects {

Vec3 vector(const std::array<double, 3>& values) {
  return {values[0], values[1], values[2]};
}

Quaternion orientation(const std::optional<Rotation>& rotation) {
  if (!rotation) return {};
  if (const auto& q = rotation->quaternion) return normalized(Quaternion{(*q)[0], (*q)[1], (*q)[2], (*q)[3]});
  if (const auto& e = rotation->euler) return from_euler((*e)[0], (*e)[1], (*e)[2]);
  return from_axis_angle(vector(rotation->axis.value()), rotation->angle.value());
}

namespace {

Pose pose_of(const Placement& placement) {
  return {vector(placement.position), orientation(placement.rotation)};
}

/// The sizes of primitive.hpp: half lengths rather than lengths.
struct PrimitiveOf {
  Primitive operator()(const SphereShape& s) const {
    return {PrimitiveKind::sphere, {s.radius, 0, 0}, pose_of(s.placement)};
  }
  Primitive operator()(const BoxShape& s) const {
    return {PrimitiveKind::box, 0.5 * vector(s.size), pose_of(s.placement)};
  }
  Primitive operator()(const CapsuleShape& s) const {
    return {PrimitiveKind::capsule, {s.radius, 0.5 * s.length - s.radius, 0}, pose_of(s.placement)};
  }
  Primitive operator()(const CylinderShape& s) const {
    return {PrimitiveKind::cylinder, {s.radius, 0.5 * s.height, 0}, pose_of(s.placement)};
  }
  Primitive operator()(const ConeShape& s) const {
    return {PrimitiveKind::cone, {s.radius, 0.5 * s.height, 0}, pose_of(s.placement)};
  }
  Primitive operator()(const EllipsoidShape& s) const {
    return {PrimitiveKind::ellipsoid, vector(s.radii), pose_of(s.placement)};
  }
  Primitive operator()(const HalfSpaceShape& s) const {
    return {PrimitiveKind::half_space, normalized(vector(s.normal)), pose_of(s.placement)};
  }
  Primitive operator()(const BrushShape& s) const {
    return {PrimitiveKind::brush, {s.radius, s.height, 0}, pose_of(s.placement)};
  }
};

Instruction instruction(SetOperation operation) {
  switch (operation) {
    case SetOperation::unite:
      return Instruction::unite;
    case SetOperation::intersect:
      return Instruction::intersect;
    case SetOperation::subtract:
      break;
  }
  return Instruction::subtract;
}

Shape shape_of(const CsgShape& csg) {
  std::vector<Primitive> primitives;
  std::vector<Instruction> instructions;
  const Pose outer = pose_of(csg.placement);
  for (const PrimitiveShape& part : csg.parts) {
    primitives.push_back(std::visit(PrimitiveOf{}, part));
    primitives.back().pose = outer * primitives.back().pose;
    instructions.push_back(Instruction::primitive);
    if (primitives.size() > 1) instructions.push_back(instruction(csg.operation));
  }
  return {primitives, instructions};
}

Shape shape_of(const MeshShape& mesh) {
  const DistanceGrid& grid = mesh.file.distance ? *mesh.file.distance : bake(*mesh.file.mesh, mesh.resolution).grid;
  return Shape(std::make_shared<DistanceGrid>(scaled(grid, factor(mesh))), pose_of(mesh.placement));
}

Shape shape_of(const SdfShape& sdf) {
  DistanceGrid grid = *sdf.file.distance;
  if (sdf.spacing) grid.spacing = *sdf.spacing;
  if (sdf.origin) grid.origin = vector(*sdf.origin);
  return Shape(std::make_shared<DistanceGrid>(scaled(grid, sdf.scale)), pose_of(sdf.placement));
}

/// Keyframes with one orientation.
std::vector<Keyframe> without_turns(const std::vector<double>& times,
                                    const std::vector<std::array<double, 3>>& positions, const Quaternion& turned) {
  std::vector<Keyframe> result;
  for (std::size_t k = 0; k < times.size(); ++k) result.push_back({times[k], {vector(positions[k]), turned}});
  return result;
}

struct MotionOf {
  const KinematicObject& object;
  Pose start;

  Motion operator()(const FixedMotion&) const { return UniformMotion{{start, {}, {}}, object.start}; }
  Motion operator()(const ConstantMotion& m) const {
    return UniformMotion{{start, vector(m.velocity), vector(m.angular_velocity)}, object.start};
  }
  Motion operator()(const Spin& m) const {
    const Vec3 center = m.center ? vector(*m.center) : start.position;
    return SpinMotion{start, object.start, center, m.rate * normalized(vector(m.axis))};
  }
  Motion operator()(const Keyframes& m) const {
    std::vector<Keyframe> keyframes;
    for (const ObjectKeyframe& k : m.keyframes) {
      keyframes.push_back({k.time, {vector(k.position), orientation(k.rotation)}});
    }
    return KeyframeMotion(keyframes, m.interpolation);
  }
  Motion operator()(const Path& m) const {
    return KeyframeMotion(without_turns(m.file.time, m.file.position, start.orientation), m.interpolation);
  }
  Motion operator()(const Stroke& m) const {
    std::vector<Keyframe> keyframes;
    for (const StrokePoint& p : m.points) keyframes.push_back({p.time, {vector(p.position), start.orientation}});
    return KeyframeMotion(keyframes, Interpolation::linear);
  }
};

}  // namespace

Shape make_shape(const ObjectShape& shape) {
  return std::visit(
      [](const auto& s) {
        if constexpr (requires { PrimitiveOf{}(s); }) {
          return Shape(PrimitiveOf{}(s));
        } else {
          return shape_of(s);
        }
      },
      shape);
}

double factor(const MeshShape& shape) {
  switch (shape.unit) {
    case MeshUnit::m:
      return shape.scale;
    case MeshUnit::cm:
      return shape.scale / 100.0;
    case MeshUnit::mm:
      return shape.scale / 1000.0;
    case MeshUnit::inch:
      break;
  }
  return shape.scale * 0.0254;
}

Bounds bounds(const ObjectShape& shape, const Pose& pose) {
  const auto* mesh = std::get_if<MeshShape>(&shape);
  if (mesh == nullptr) return make_shape(shape).bounds(pose);
  const Bounds own = bounds(*mesh->file.mesh);
  return around({factor(*mesh) * own.low, factor(*mesh) * own.high}, pose * pose_of(mesh->placement));
}

Motion make_motion(const KinematicObject& object) {
  return std::visit(MotionOf{object, {vector(object.position), orientation(object.rotation)}}, object.motion);
}

Object::Object(const KinematicObject& object, double grid_spacing)
    : name_(object.name),
      shape_(make_shape(object.shape)),
      motion_(make_motion(object)),
      coupling_(object.coupling),
      vertical_(object.vertical),
      sample_spacing_(object.sample_spacing.value_or(grid_spacing)),
      start_(object.start),
      end_(object.end.value_or(std::numeric_limits<double>::infinity())),
      changes_until_(std::isfinite(end_) ? end_
                                         : std::max(objects::moves_until(motion_), start_ > 0.0 ? start_ : -HUGE_VAL)),
      reach_(reach(shape_.bounds({}))) {}

double Object::top_speed(const RigidState& state) const {
  return length(state.velocity) +
         (length(state.angular_velocity) > 0.0 ? length(state.angular_velocity) * reach_ : 0.0);
}

}  // namespace sandsim::objects
