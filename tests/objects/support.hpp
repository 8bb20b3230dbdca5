// What the tests of objects share: comparisons and random geometry.
#pragma once

#include <random>

#include "solver/objects/rotation.hpp"
#include "tests/support/catch.hpp"

namespace sandsim::test {

using objects::Vec3;

/// Largest difference of a component.
inline double difference(const Vec3& a, const Vec3& b) {
  return std::fmax(std::abs(a.x - b.x), std::fmax(std::abs(a.y - b.y), std::abs(a.z - b.z)));
}

/// Largest difference of what two rotations do to the axes; q and -q are the same.
inline double difference(const objects::Quaternion& a, const objects::Quaternion& b) {
  double largest = 0.0;
  for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
    largest = std::fmax(largest, difference(rotate(a, axis), rotate(b, axis)));
  }
  return largest;
}

/// The same numbers in every run.
class Random {
 public:
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  Vec3 vector(double size) { return {between(-size, size), between(-size, size), between(-size, size)}; }
  objects::Pose pose(double size) { return {vector(size), objects::exponential(vector(3.0))}; }

 private:
  std::mt19937_64 engine_{1};
};

}  // namespace sandsim::test
