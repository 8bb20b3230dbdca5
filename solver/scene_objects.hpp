// Kinematic objects of a scene: bodies that move as they are told and push the sand.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "solver/objects/motion.hpp"

namespace sandsim {

namespace objects {
struct TriangleMesh;
struct DistanceGrid;
}  // namespace objects

/// displace: the sand that an object overlaps is moved out of its way. drag: it takes on the object's velocity (section
/// 5 of the paper). solid: no sand stays inside; where it stands still it is terrain.
enum class Coupling { displace, drag, solid };
/// Of drag: how an object's vertical velocity moves sand sideways. eq. 23 per component, eq. 24 as printed, not at all.
enum class VerticalTransfer { derived, printed, none };
enum class SetOperation { unite, intersect, subtract };
enum class MeshUnit { m, cm, mm, inch };

// ---- where things lie -----------------------------------------------------------------------------------------------
/// Exactly one of the three is set; with an axis the angle too.
struct Rotation {
  std::optional<std::array<double, 3>> axis;        // [-] any length but 0
  std::optional<double> angle;                      // [rad] about the axis
  std::optional<std::array<double, 4>> quaternion;  // [-] w, x, y, z; any length but 0
  std::optional<std::array<double, 3>> euler;       // [rad] first about x, then y, then z, axes of the scene
};
/// Where a shape lies in the frame of its object; the object turns about that frame's origin.
struct Placement {
  std::array<double, 3> position{0.0, 0.0, 0.0};  // [m]
  std::optional<Rotation> rotation;
};

// ---- shapes: about the origin, their axes along z -------------------------------------------------------------------
struct SphereShape {
  double radius = 0.0;  // [m]
  Placement placement;
};
struct BoxShape {
  std::array<double, 3> size{0.0, 0.0, 0.0};  // [m]
  Placement placement;
};
/// A cylinder with round caps; `length` is that of the whole.
struct CapsuleShape {
  double radius = 0.0;  // [m]
  double length = 0.0;  // [m] at least 2 radius
  Placement placement;
};
struct CylinderShape {
  double radius = 0.0;  // [m]
  double height = 0.0;  // [m]
  Placement placement;
};
/// Tip up; half its height lies above the origin.
struct ConeShape {
  double radius = 0.0;  // [m] of the base
  double height = 0.0;  // [m]
  Placement placement;
};
struct EllipsoidShape {
  std::array<double, 3> radii{0.0, 0.0, 0.0};  // [m]
  Placement placement;
};
/// Everything on the side of the plane that the normal points away from.
struct HalfSpaceShape {
  std::array<double, 3> normal{0.0, 0.0, 1.0};  // [-] any length but 0
  Placement placement;
};
/// An upright cylinder whose lower end is at the origin: the position is that of its tip.
struct BrushShape {
  double radius = 0.0;  // [m]
  double height = 0.0;  // [m]
  Placement placement;
};
using PrimitiveShape = std::variant<SphereShape, BoxShape, CapsuleShape, CylinderShape, ConeShape, EllipsoidShape,
                                    HalfSpaceShape, BrushShape>;

/// Constructive solid geometry: the union or the intersection of the parts, or the first without the others.
struct CsgShape {
  SetOperation operation = SetOperation::unite;
  std::vector<PrimitiveShape> parts;
  Placement placement;
};

struct MeshFile {
  std::string file;                                       // as written in the scene
  std::shared_ptr<const objects::TriangleMesh> mesh;      // never null in a scene that was read
  std::shared_ptr<const objects::DistanceGrid> distance;  // null until it has been baked
};
/// Triangles, turned into a sampled signed distance when the run starts.
struct MeshShape {
  MeshFile file;
  MeshUnit unit = MeshUnit::m;  // of the file's coordinates
  double scale = 1.0;
  int resolution = 96;  // samples along the longest side of the mesh
  Placement placement;
};

struct SdfFile {
  std::string file;                                       // as written in the scene
  std::shared_ptr<const objects::DistanceGrid> distance;  // never null in a scene that was read
};
/// A signed distance that a file holds, in metres, negative inside.
struct SdfShape {
  SdfFile file;
  std::optional<double> spacing;                // [m] set if the file knows none, as .npy
  std::optional<std::array<double, 3>> origin;  // [m] likewise: the first sample
  double scale = 1.0;
  Placement placement;
};

using ObjectShape = std::variant<SphereShape, BoxShape, CapsuleShape, CylinderShape, ConeShape, EllipsoidShape,
                                 HalfSpaceShape, BrushShape, CsgShape, MeshShape, SdfShape>;

// ---- motions --------------------------------------------------------------------------------------------------------
struct FixedMotion {};
/// From the object's start on.
struct ConstantMotion {
  std::array<double, 3> velocity{0.0, 0.0, 0.0};          // [m/s]
  std::array<double, 3> angular_velocity{0.0, 0.0, 0.0};  // [rad/s] about the object's position
};
/// About a fixed axis, from the object's start on.
struct Spin {
  std::array<double, 3> axis{0.0, 0.0, 1.0};    // [-] any length but 0
  double rate = 0.0;                            // [rad/s] counterclockwise when looked at from the axis's tip
  std::optional<std::array<double, 3>> center;  // [m] a point of the axis; absent: the object's position
};
struct ObjectKeyframe {
  double time = 0.0;                              // [s]
  std::array<double, 3> position{0.0, 0.0, 0.0};  // [m]
  std::optional<Rotation> rotation;
};
struct Keyframes {
  objects::Interpolation interpolation = objects::Interpolation::linear;
  std::vector<ObjectKeyframe> keyframes;
};
/// A table of (time, x, y, z), ascending in time.
struct PathTable {
  std::string file;                             // as written in the scene
  std::vector<double> time;                     // [s]
  std::vector<std::array<double, 3>> position;  // [m]
};
struct Path {
  PathTable file;
  objects::Interpolation interpolation = objects::Interpolation::linear;
};
struct StrokePoint {
  double time = 0.0;                              // [s]
  std::array<double, 3> position{0.0, 0.0, 0.0};  // [m]
};
/// Evenly from point to point.
struct Stroke {
  std::vector<StrokePoint> points;
};
using ObjectMotion = std::variant<FixedMotion, ConstantMotion, Spin, Keyframes, Path, Stroke>;

/// Position and rotation are those of the start; keyframes have their own, a path and a stroke their own positions.
struct KinematicObject {
  std::string name;
  ObjectShape shape;
  ObjectMotion motion;
  std::array<double, 3> position{0.0, 0.0, 0.0};  // [m]
  std::optional<Rotation> rotation;
  Coupling coupling = Coupling::displace;
  VerticalTransfer vertical = VerticalTransfer::derived;
  std::optional<double> sample_spacing;  // [m] of sampled shapes along a column of sand; absent: the grid's spacing
  double start = 0.0;                    // [s] the object is there from then on
  std::optional<double> end;             // [s] and until then; absent: to the end of the run

  /// Solid and always in one place: part of the terrain, at no cost in the steps.
  bool is_terrain() const {
    return coupling == Coupling::solid && std::holds_alternative<FixedMotion>(motion) && start == 0.0 && !end;
  }
};

}  // namespace sandsim
