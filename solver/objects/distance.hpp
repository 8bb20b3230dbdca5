// Signed distances to primitives: negative inside, 0 on the surface.
#pragma once

#include "solver/objects/primitive.hpp"

namespace sandsim::objects {

namespace detail {

SANDSIM_HD double larger(double a, double b) {
  return a > b ? a : b;
}
SANDSIM_HD double smaller(double a, double b) {
  return a < b ? a : b;
}

/// Distance to a solid whose surface lies at distances a and b along two axes, e.g. a rectangle's sides: the larger one
/// inside and beside a side, the distance to the edge beyond both.
SANDSIM_HD double distance_to_corner(double a, double b) {
  const double beyond_a = larger(a, 0.0);
  const double beyond_b = larger(b, 0.0);
  return smaller(larger(a, b), 0.0) + std::sqrt(beyond_a * beyond_a + beyond_b * beyond_b);
}

SANDSIM_HD double distance_to_box(const Vec3& p, const Vec3& half) {
  const Vec3 d{std::abs(p.x) - half.x, std::abs(p.y) - half.y, std::abs(p.z) - half.z};
  const Vec3 beyond{larger(d.x, 0.0), larger(d.y, 0.0), larger(d.z, 0.0)};
  return smaller(larger(d.x, larger(d.y, d.z)), 0.0) + length(beyond);
}

SANDSIM_HD double distance_to_cone(const Vec3& p, double radius, double half) {
  // In the plane of the axis and the point: from the nearest point of the base and of the slant.
  const double rho = std::sqrt(p.x * p.x + p.y * p.y);
  const double slant_length = std::sqrt(radius * radius + 4.0 * half * half);
  const double along =
      larger(0.0, smaller(1.0, (radius * (radius - rho) + 2.0 * half * (p.z + half)) / (slant_length * slant_length)));
  const double to_slant_rho = rho - radius * (1.0 - along);
  const double to_slant_z = p.z + half * (1.0 - 2.0 * along);
  const double to_base_rho = larger(rho - radius, 0.0);
  const double to_base_z = p.z + half;
  const double to_slant = to_slant_rho * to_slant_rho + to_slant_z * to_slant_z;
  const double to_base = to_base_rho * to_base_rho + to_base_z * to_base_z;
  const double size = std::sqrt(smaller(to_slant, to_base));
  const bool is_inside = p.z > -half && 2.0 * half * rho < radius * (half - p.z);
  return is_inside ? -size : size;
}

/// (|p/r| - 1) min r: |p/r| changes by at most |dp|/min r, so that this never exceeds the distance.
SANDSIM_HD double distance_to_ellipsoid(const Vec3& p, const Vec3& r) {
  return (length({p.x / r.x, p.y / r.y, p.z / r.z}) - 1.0) * smaller(r.x, smaller(r.y, r.z));
}

}  // namespace detail

/// Distance [m] in the primitive's own frame. Exact to rounding, except for an ellipsoid: a lower bound of it.
SANDSIM_HD double distance_own_frame(const Primitive& primitive, const Vec3& p) {
  const Vec3 size = primitive.size;
  const double rho = std::sqrt(p.x * p.x + p.y * p.y);
  switch (primitive.kind) {
    case PrimitiveKind::sphere:
      return length(p) - size.x;
    case PrimitiveKind::box:
      return detail::distance_to_box(p, size);
    case PrimitiveKind::capsule:
      return length({p.x, p.y, p.z - detail::larger(-size.y, detail::smaller(size.y, p.z))}) - size.x;
    case PrimitiveKind::cylinder:
      return detail::distance_to_corner(rho - size.x, std::abs(p.z) - size.y);
    case PrimitiveKind::cone:
      return detail::distance_to_cone(p, size.x, size.y);
    case PrimitiveKind::ellipsoid:
      return detail::distance_to_ellipsoid(p, size);
    case PrimitiveKind::half_space:
      return dot(size, p);
    case PrimitiveKind::brush:
      return detail::distance_to_corner(rho - size.x, std::abs(p.z - 0.5 * size.y) - 0.5 * size.y);
  }
  return endless;
}

/// The same for a point in the frame of the shape.
SANDSIM_HD double distance(const Primitive& primitive, const Vec3& point) {
  return distance_own_frame(primitive, to_local(primitive.pose, point));
}

}  // namespace sandsim::objects
