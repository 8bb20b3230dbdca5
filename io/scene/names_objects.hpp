// The words that scenes use for kinematic objects; see names.hpp.
#pragma once

#include "io/scene/type_name.hpp"
#include "solver/scene_objects.hpp"

namespace sandsim {

template <>
struct EnumNames<Coupling> {
  static constexpr std::array names{"displace", "drag", "solid"};
};
template <>
struct EnumNames<VerticalTransfer> {
  static constexpr std::array names{"derived", "printed", "none"};
};
template <>
struct EnumNames<SetOperation> {
  static constexpr std::array names{"union", "intersection", "difference"};
};
template <>
struct EnumNames<MeshUnit> {
  static constexpr std::array names{"m", "cm", "mm", "in"};
};
template <>
struct EnumNames<objects::Interpolation> {
  static constexpr std::array names{"linear", "cubic"};
};

template <>
struct TypeName<SphereShape> {
  static constexpr const char* name = "sphere";
  static constexpr const char* purpose = "A sphere about its position.";
};
template <>
struct TypeName<BoxShape> {
  static constexpr const char* name = "box";
  static constexpr const char* purpose = "A box about its position.";
};
template <>
struct TypeName<CapsuleShape> {
  static constexpr const char* name = "capsule";
  static constexpr const char* purpose = "A cylinder with round caps about its position, its axis along z.";
};
template <>
struct TypeName<CylinderShape> {
  static constexpr const char* name = "cylinder";
  static constexpr const char* purpose = "A cylinder about its position, its axis along z.";
};
template <>
struct TypeName<ConeShape> {
  static constexpr const char* name = "cone";
  static constexpr const char* purpose = "A cone with its tip up; its position is half-way up its axis.";
};
template <>
struct TypeName<EllipsoidShape> {
  static constexpr const char* name = "ellipsoid";
  static constexpr const char* purpose = "An ellipsoid about its position.";
};
template <>
struct TypeName<HalfSpaceShape> {
  static constexpr const char* name = "half_space";
  static constexpr const char* purpose = "Everything below a plane through its position, seen along the normal.";
};
template <>
struct TypeName<BrushShape> {
  static constexpr const char* name = "brush";
  static constexpr const char* purpose = "An upright cylinder that stands on its position, its tip.";
};
template <>
struct TypeName<CsgShape> {
  static constexpr const char* name = "csg";
  static constexpr const char* purpose = "Constructive solid geometry: several shapes joined by a set operation.";
};
template <>
struct TypeName<MeshShape> {
  static constexpr const char* name = "mesh";
  static constexpr const char* purpose =
      "Triangles from a file. When the run starts they are turned into a sampled signed distance; the mesh should be "
      "closed.";
};
template <>
struct TypeName<SdfShape> {
  static constexpr const char* name = "sdf";
  static constexpr const char* purpose = "A sampled signed distance from a file, in metres, negative inside.";
};

template <>
struct TypeName<FixedMotion> {
  static constexpr const char* name = "fixed";
  static constexpr const char* purpose = "The object stays where it is.";
};
template <>
struct TypeName<ConstantMotion> {
  static constexpr const char* name = "constant";
  static constexpr const char* purpose = "Constant velocity and angular velocity from the object's start on.";
};
template <>
struct TypeName<Spin> {
  static constexpr const char* name = "spin";
  static constexpr const char* purpose = "Rotation about a fixed axis from the object's start on.";
};
template <>
struct TypeName<Keyframes> {
  static constexpr const char* name = "keyframes";
  static constexpr const char* purpose = "Positions and rotations at given times.";
};
template <>
struct TypeName<Path> {
  static constexpr const char* name = "path";
  static constexpr const char* purpose = "Positions over time from a table.";
};
template <>
struct TypeName<Stroke> {
  static constexpr const char* name = "stroke";
  static constexpr const char* purpose = "A polyline of points in time, as a pen or a brush draws it.";
};

}  // namespace sandsim
