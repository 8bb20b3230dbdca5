#include "solver/objects/rotation.hpp"

#include <algorithm>
#include <stdexcept>

namespace sandsim::objects {

namespace {

/// Below this angle [rad] series of three terms are exact to rounding: the next term is under 1e-16 of the first.
constexpr double small_angle = 1e-2;

/// sin(a/2)/a.
double half_sine_ratio(double angle) {
  const double squared = angle * angle;
  if (angle < small_angle) return 0.5 - squared * (1.0 / 48.0 - squared / 3840.0);
  return std::sin(0.5 * angle) / angle;
}

/// (1 - cos a)/a^2, written so that nothing cancels.
double versine_ratio(double angle) {
  const double ratio = half_sine_ratio(angle);
  return 2.0 * ratio * ratio;
}

/// (a - sin a)/a^3.
double excess_ratio(double angle) {
  const double squared = angle * angle;
  // Above 0.5 rad the subtraction costs less than 6 bits; below it nine terms of the series are exact to rounding.
  if (angle > 0.5) return (angle - std::sin(angle)) / (squared * angle);
  double sum = 0.0;
  double term = 1.0 / 6.0;
  for (int k = 2; k <= 10; ++k) {
    sum += term;
    term *= -squared / ((2.0 * k) * (2.0 * k + 1.0));
  }
  return sum;
}

}  // namespace

Vec3 normalized(const Vec3& v) {
  const Quaternion q = normalized(Quaternion{0.0, v.x, v.y, v.z});
  return q.vector();
}

Quaternion normalized(const Quaternion& q) {
  // First by the largest component, so that no square underflows or overflows.
  const double largest = std::max({std::abs(q.w), std::abs(q.x), std::abs(q.y), std::abs(q.z)});
  if (!(largest > 0.0) || !std::isfinite(largest)) throw std::invalid_argument("what has no length has no direction");
  const Quaternion p{q.w / largest, q.x / largest, q.y / largest, q.z / largest};
  const double size = std::sqrt(p.w * p.w + p.x * p.x + p.y * p.y + p.z * p.z);
  return {p.w / size, p.x / size, p.y / size, p.z / size};
}

Quaternion from_axis_angle(const Vec3& axis, double angle) {
  const Vec3 unit = normalized(axis);
  const double sine = std::sin(0.5 * angle);
  return normalized(Quaternion{std::cos(0.5 * angle), sine * unit.x, sine * unit.y, sine * unit.z});
}

Quaternion from_euler(double roll, double pitch, double yaw) {
  return from_axis_angle({0, 0, 1}, yaw) * from_axis_angle({0, 1, 0}, pitch) * from_axis_angle({1, 0, 0}, roll);
}

Quaternion exponential(const Vec3& v) {
  const double angle = length(v);
  const Vec3 part = half_sine_ratio(angle) * v;
  return normalized(Quaternion{std::cos(0.5 * angle), part.x, part.y, part.z});
}

Vec3 logarithm(const Quaternion& q) {
  const double sine = length(q.vector());
  // The nearer of q and -q is the shorter way.
  const double sign = q.w < 0.0 ? -1.0 : 1.0;
  const double angle = 2.0 * std::atan2(sine, sign * q.w);
  return (sign / half_sine_ratio(angle)) * q.vector();
}

Vec3 body_rate(const Vec3& v, const Vec3& rate) {
  const double angle = length(v);
  const Vec3 once = cross(v, rate);
  return rate - versine_ratio(angle) * once + excess_ratio(angle) * cross(v, once);
}

Vec3 inverse_body_rate(const Vec3& v, const Vec3& angular_velocity) {
  const double angle = length(v);
  const double squared = angle * angle;
  const Vec3 once = cross(v, angular_velocity);
  // (1 - (a/2) cot(a/2))/a^2; below 0.1 rad by its series, whose next term is under 1e-12.
  const double second = angle < 0.1 ? 1.0 / 12.0 + squared * (1.0 / 720.0 + squared / 30240.0)
                                    : (1.0 - 0.5 * angle * std::cos(0.5 * angle) / std::sin(0.5 * angle)) / squared;
  return angular_velocity + 0.5 * once + second * cross(v, once);
}

}  // namespace sandsim::objects
