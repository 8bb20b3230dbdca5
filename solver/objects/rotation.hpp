// Rotations from the numbers that people write, and their logarithm. On the host only: sines differ between devices.
#pragma once

#include "solver/objects/vec3.hpp"

namespace sandsim::objects {

/// The vector scaled to length 1. Throws std::invalid_argument if it is 0 or not finite.
Vec3 normalized(const Vec3& v);

/// The quaternion scaled to length 1. Throws std::invalid_argument if its length is 0 or not finite.
Quaternion normalized(const Quaternion& q);

/// Rotation about `axis` (any length but 0) by `angle` [rad], counterclockwise when looked at from the axis's tip.
Quaternion from_axis_angle(const Vec3& axis, double angle);

/// First roll about x, then pitch about y, then yaw about z; the axes stay those of the outer frame. [rad]
Quaternion from_euler(double roll, double pitch, double yaw);

/// Rotation about v / |v| by |v| [rad]; the identity for v = 0.
Quaternion exponential(const Vec3& v);
/// The shortest v with exponential(v) = q, at most pi long.
Vec3 logarithm(const Quaternion& q);

/// Angular velocity, in the frame that exponential(v) has turned, of a rotation exponential(v(t)) with v' = `rate`:
/// J(v) v' with the right Jacobian of the rotation group (Sola et al. 2018, eq. 143).
Vec3 body_rate(const Vec3& v, const Vec3& rate);
/// The v' that gives this angular velocity; |v| < 2 pi (eq. 144).
Vec3 inverse_body_rate(const Vec3& v, const Vec3& angular_velocity);

}  // namespace sandsim::objects
