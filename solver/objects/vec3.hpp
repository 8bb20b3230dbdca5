// Vectors, rotations and poses in space, for objects. Double precision on every device.
#pragma once

#include <cmath>

#include "solver/physics/math.hpp"

namespace sandsim::objects {

struct Vec3 {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;

  bool operator==(const Vec3&) const = default;
};

SANDSIM_HD Vec3 operator+(const Vec3& a, const Vec3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
SANDSIM_HD Vec3 operator-(const Vec3& a, const Vec3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
SANDSIM_HD Vec3 operator-(const Vec3& a) {
  return {-a.x, -a.y, -a.z};
}
SANDSIM_HD Vec3 operator*(double factor, const Vec3& a) {
  return {factor * a.x, factor * a.y, factor * a.z};
}
SANDSIM_HD double dot(const Vec3& a, const Vec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
SANDSIM_HD Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
SANDSIM_HD double length(const Vec3& a) {
  return std::sqrt(dot(a, a));
}

/// A rotation as a unit quaternion w + x i + y j + z k; q and -q are the same rotation.
struct Quaternion {
  double w = 1.0;
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;

  bool operator==(const Quaternion&) const = default;
  SANDSIM_HD Vec3 vector() const { return {x, y, z}; }
};

/// First b, then a.
SANDSIM_HD Quaternion operator*(const Quaternion& a, const Quaternion& b) {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}
SANDSIM_HD Quaternion inverse(const Quaternion& q) {
  return {q.w, -q.x, -q.y, -q.z};
}
SANDSIM_HD Vec3 rotate(const Quaternion& q, const Vec3& v) {
  const Vec3 twice = 2.0 * cross(q.vector(), v);
  return v + q.w * twice + cross(q.vector(), twice);
}

/// Where a frame lies in another one: a point p of the frame is at position + rotate(orientation, p).
struct Pose {
  Vec3 position;  // [m]
  Quaternion orientation;

  bool operator==(const Pose&) const = default;
};

SANDSIM_HD Vec3 to_outer(const Pose& pose, const Vec3& point) {
  return pose.position + rotate(pose.orientation, point);
}
SANDSIM_HD Vec3 to_local(const Pose& pose, const Vec3& point) {
  return rotate(inverse(pose.orientation), point - pose.position);
}
/// The pose of a frame that lies at `inner` in a frame that lies at `outer`.
SANDSIM_HD Pose operator*(const Pose& outer, const Pose& inner) {
  return {to_outer(outer, inner.position), outer.orientation * inner.orientation};
}

}  // namespace sandsim::objects
