// Convex solids with an exact answer to "where is this line inside?". Lines are origin + t direction.
//
// Each lies about the origin of its own frame, its axis along z:
//   kind         size.x          size.y         size.z
//   sphere       radius
//   box          half length x   half length y  half length z
//   capsule      radius          half length of the axis (between the centres of its caps)
//   cylinder     radius          half height
//   cone         radius at z = -half height     half height (size.y); its tip is at z = +half height
//   ellipsoid    radius x        radius y       radius z
//   half_space   unit normal; inside where it points away from
//   brush        radius          height; it stands on the origin
#pragma once

#include "solver/objects/vec3.hpp"

namespace sandsim::objects {

/// "Without end" for coordinates and line parameters: so large that no product of two of them overflows.
inline constexpr double endless = 1e150;

/// The parameters from < t < to; empty unless from < to.
struct Interval {
  double from = 0.0;
  double to = 0.0;

  SANDSIM_HD bool empty() const { return !(from < to); }
};

SANDSIM_HD Interval intersection(const Interval& a, const Interval& b) {
  return {a.from > b.from ? a.from : b.from, a.to < b.to ? a.to : b.to};
}

struct Line {
  Vec3 origin;
  Vec3 direction;
};

enum class PrimitiveKind : int { sphere, box, capsule, cylinder, cone, ellipsoid, half_space, brush };

/// A solid and where it lies in the shape that it is part of.
struct Primitive {
  PrimitiveKind kind = PrimitiveKind::sphere;
  Vec3 size;  // [m]
  Pose pose;
};

namespace detail {

/// Where a t^2 + 2 b t + c < 0, for a > 0.
SANDSIM_HD Interval below_parabola(double a, double b, double c) {
  const double discriminant = b * b - a * c;
  if (!(discriminant > 0.0)) return {};
  // Of the two roots the one without cancellation first; their product is c/a.
  const double q = b > 0.0 ? -(b + std::sqrt(discriminant)) : -b + std::sqrt(discriminant);
  const double one = q / a;
  const double other = c / q;
  return one < other ? Interval{one, other} : Interval{other, one};
}

/// Where |origin + t direction| < half.
SANDSIM_HD Interval inside_slab(double origin, double direction, double half) {
  if (direction == 0.0) return origin > -half && origin < half ? Interval{-endless, endless} : Interval{};
  const double one = (-half - origin) / direction;
  const double other = (half - origin) / direction;
  return one < other ? Interval{one, other} : Interval{other, one};
}

SANDSIM_HD Interval inside_sphere(const Line& l, double radius) {
  // About the point nearest to the centre, where b = 0: no cancellation for origins far away.
  const double a = dot(l.direction, l.direction);
  const double nearest = -dot(l.origin, l.direction) / a;
  const Vec3 p = l.origin + nearest * l.direction;
  const double squared = (radius * radius - dot(p, p)) / a;
  if (!(squared > 0.0)) return {};
  const double half = std::sqrt(squared);
  return {nearest - half, nearest + half};
}

/// The cylinder without ends.
SANDSIM_HD Interval inside_tube(const Line& l, double radius) {
  const double a = l.direction.x * l.direction.x + l.direction.y * l.direction.y;
  const double c = l.origin.x * l.origin.x + l.origin.y * l.origin.y - radius * radius;
  if (a == 0.0) return c < 0.0 ? Interval{-endless, endless} : Interval{};
  return below_parabola(a, l.origin.x * l.direction.x + l.origin.y * l.direction.y, c);
}

SANDSIM_HD Interval inside_capsule(const Line& l, double radius, double half) {
  // The union of a cylinder and two spheres; it is convex, so that the three intervals join into one.
  const Interval parts[3] = {intersection(inside_tube(l, radius), inside_slab(l.origin.z, l.direction.z, half)),
                             inside_sphere({{l.origin.x, l.origin.y, l.origin.z - half}, l.direction}, radius),
                             inside_sphere({{l.origin.x, l.origin.y, l.origin.z + half}, l.direction}, radius)};
  Interval joined{};
  for (const Interval& part : parts) {
    if (part.empty()) continue;
    joined = joined.empty() ? part
                            : Interval{part.from < joined.from ? part.from : joined.from,
                                       part.to > joined.to ? part.to : joined.to};
  }
  return joined;
}

SANDSIM_HD Interval inside_cone(const Line& l, double radius, double half) {
  const Interval slab = inside_slab(l.origin.z, l.direction.z, half);
  if (slab.empty()) return {};
  // Both nappes: x^2 + y^2 < slope^2 (half - z)^2; the slab leaves the lower one.
  const double slope = radius / (2.0 * half);
  const double down = slope * (half - l.origin.z);  // radius of the cone at the origin's height
  const double rate = -slope * l.direction.z;       // and its growth along the line
  const double a = l.direction.x * l.direction.x + l.direction.y * l.direction.y - rate * rate;
  const double b = l.origin.x * l.direction.x + l.origin.y * l.direction.y - down * rate;
  const double c = l.origin.x * l.origin.x + l.origin.y * l.origin.y - down * down;
  if (a > 0.0) return intersection(slab, below_parabola(a, b, c));
  if (a == 0.0) {
    if (b == 0.0) return c < 0.0 ? slab : Interval{};
    const double crossing = -0.5 * c / b;
    return intersection(slab, b > 0.0 ? Interval{-endless, crossing} : Interval{crossing, endless});
  }
  // Steeper than the cone: outside between the roots, inside beyond them, one nappe on each side.
  const Interval outside = below_parabola(-a, -b, -c);
  const double root = rate > 0.0 ? outside.to : outside.from;
  // No roots: the line goes through the tip, which the slab ends at.
  if (outside.empty()) return slab;
  return intersection(slab, rate > 0.0 ? Interval{root, endless} : Interval{-endless, root});
}

SANDSIM_HD Interval inside_half_space(const Line& l, const Vec3& normal) {
  const double height = dot(normal, l.origin);
  const double rate = dot(normal, l.direction);
  if (rate == 0.0) return height < 0.0 ? Interval{-endless, endless} : Interval{};
  const double crossing = -height / rate;
  return rate > 0.0 ? Interval{-endless, crossing} : Interval{crossing, endless};
}

}  // namespace detail

/// Where a line is inside, in the primitive's own frame. Exact to rounding. The direction is not 0.
SANDSIM_HD Interval inside_own_frame(const Primitive& p, const Line& line) {
  switch (p.kind) {
    case PrimitiveKind::sphere:
      return detail::inside_sphere(line, p.size.x);
    case PrimitiveKind::box:
      return intersection(intersection(detail::inside_slab(line.origin.x, line.direction.x, p.size.x),
                                       detail::inside_slab(line.origin.y, line.direction.y, p.size.y)),
                          detail::inside_slab(line.origin.z, line.direction.z, p.size.z));
    case PrimitiveKind::capsule:
      return detail::inside_capsule(line, p.size.x, p.size.y);
    case PrimitiveKind::cylinder:
      return intersection(detail::inside_tube(line, p.size.x),
                          detail::inside_slab(line.origin.z, line.direction.z, p.size.y));
    case PrimitiveKind::cone:
      return detail::inside_cone(line, p.size.x, p.size.y);
    case PrimitiveKind::ellipsoid: {
      const Vec3 r = p.size;
      return detail::inside_sphere({{line.origin.x / r.x, line.origin.y / r.y, line.origin.z / r.z},
                                    {line.direction.x / r.x, line.direction.y / r.y, line.direction.z / r.z}},
                                   1.0);
    }
    case PrimitiveKind::half_space:
      return detail::inside_half_space(line, p.size);
    case PrimitiveKind::brush: {
      const double half = 0.5 * p.size.y;
      return intersection(detail::inside_tube(line, p.size.x),
                          detail::inside_slab(line.origin.z - half, line.direction.z, half));
    }
  }
  return {};
}

/// The same for a line in the frame of the shape.
SANDSIM_HD Interval inside(const Primitive& p, const Line& line) {
  return inside_own_frame(p, {to_local(p.pose, line.origin), rotate(inverse(p.pose.orientation), line.direction)});
}

}  // namespace sandsim::objects
