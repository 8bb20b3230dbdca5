#include "solver/objects/bounds.hpp"

#include <algorithm>

namespace sandsim::objects {

namespace {

constexpr Bounds everywhere{{-endless, -endless, -endless}, {endless, endless, endless}};

Bounds about(const Vec3& center, const Vec3& half) {
  return {center - half, center + half};
}

bool is_endless(const Bounds& b) {
  return b.low.x <= -endless || b.low.y <= -endless || b.low.z <= -endless || b.high.x >= endless ||
         b.high.y >= endless || b.high.z >= endless;
}

/// Half the extent along the axes of a disc whose unit normal is `axis`.
Vec3 disc_half(const Vec3& axis, double radius) {
  const auto half = [radius](double a) { return radius * std::sqrt(std::max(0.0, 1.0 - a * a)); };
  return {half(axis.x), half(axis.y), half(axis.z)};
}

Vec3 absolute(const Vec3& v) {
  return {std::abs(v.x), std::abs(v.y), std::abs(v.z)};
}

/// Half the extent along the axes of an ellipsoid with these half-axes.
Vec3 ellipsoid_half(const Vec3& a, const Vec3& b, const Vec3& c) {
  return {std::sqrt(a.x * a.x + b.x * b.x + c.x * c.x), std::sqrt(a.y * a.y + b.y * b.y + c.y * c.y),
          std::sqrt(a.z * a.z + b.z * b.z + c.z * c.z)};
}

}  // namespace

Bounds unite(const Bounds& a, const Bounds& b) {
  Bounds result = a;
  result.include(b.low);
  result.include(b.high);
  return a.empty() ? b : b.empty() ? a : result;
}

Bounds intersect(const Bounds& a, const Bounds& b) {
  return {{std::max(a.low.x, b.low.x), std::max(a.low.y, b.low.y), std::max(a.low.z, b.low.z)},
          {std::min(a.high.x, b.high.x), std::min(a.high.y, b.high.y), std::min(a.high.z, b.high.z)}};
}

Bounds around(const Bounds& box, const Pose& pose) {
  if (box.empty()) return {};
  if (is_endless(box)) return everywhere;
  const Vec3 half = 0.5 * (box.high - box.low);
  return around(Primitive{PrimitiveKind::box, half, {0.5 * (box.low + box.high), {}}}, pose);
}

Bounds around(const Primitive& primitive, const Pose& outer) {
  const Pose pose = outer * primitive.pose;
  const Vec3 size = primitive.size;
  const Vec3 center = pose.position;
  const Vec3 x = rotate(pose.orientation, {1, 0, 0});
  const Vec3 y = rotate(pose.orientation, {0, 1, 0});
  const Vec3 z = rotate(pose.orientation, {0, 0, 1});
  switch (primitive.kind) {
    case PrimitiveKind::sphere:
      return about(center, {size.x, size.x, size.x});
    case PrimitiveKind::box:
      return about(center, absolute(size.x * x) + absolute(size.y * y) + absolute(size.z * z));
    case PrimitiveKind::capsule:
      return about(center, absolute(size.y * z) + Vec3{size.x, size.x, size.x});
    case PrimitiveKind::cylinder:
      return about(center, absolute(size.y * z) + disc_half(z, size.x));
    case PrimitiveKind::cone: {
      Bounds result = about(center - size.y * z, disc_half(z, size.x));
      result.include(center + size.y * z);
      return result;
    }
    case PrimitiveKind::ellipsoid:
      return about(center, ellipsoid_half(size.x * x, size.y * y, size.z * z));
    case PrimitiveKind::half_space:
      break;
    case PrimitiveKind::brush:
      return about(center + 0.5 * size.y * z, absolute(0.5 * size.y * z) + disc_half(z, size.x));
  }
  return everywhere;
}

double reach(const Bounds& box) {
  if (box.empty()) return 0.0;
  if (is_endless(box)) return endless;
  const auto farther = [](double a, double b) { return std::max(std::abs(a), std::abs(b)); };
  return length({farther(box.low.x, box.high.x), farther(box.low.y, box.high.y), farther(box.low.z, box.high.z)});
}

}  // namespace sandsim::objects
