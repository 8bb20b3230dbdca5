// How objects move: a pose for every time, and its exact derivatives.
#pragma once

#include <variant>
#include <vector>

#include "solver/objects/vec3.hpp"

namespace sandsim::objects {

/// A pose and how it changes: the point at `r` from the pose's position moves at velocity + angular_velocity x r.
/// All in the frame of the scene.
struct RigidState {
  Pose pose;
  Vec3 velocity;          // [m/s] of the pose's position
  Vec3 angular_velocity;  // [rad/s]

  SANDSIM_HD Vec3 velocity_at(const Vec3& point) const {
    return velocity + cross(angular_velocity, point - pose.position);
  }
};

/// Constant velocity and angular velocity from `start_time` on; at rest with both 0.
struct UniformMotion {
  RigidState start;
  double start_time = 0.0;  // [s]

  RigidState at(double time) const;
};

/// Rotation at a constant rate about an axis through `center`, which need not be the pose's position.
struct SpinMotion {
  Pose start;
  double start_time = 0.0;  // [s]
  Vec3 center;              // [m]
  Vec3 angular_velocity;    // [rad/s]

  RigidState at(double time) const;
};

struct Keyframe {
  double time = 0.0;  // [s]
  Pose pose;
};

enum class Interpolation { linear, cubic };

/// Through keyframes; at rest before the first and from the last one on.
///
/// linear: constant velocity and, the shorter way round, constant angular velocity between two keyframes (slerp); at
/// a keyframe those of what follows.
/// cubic: continuous velocities. A keyframe's velocity is that of the parabola through it and its two neighbours, the
/// first's and the last's that of the outermost parabola; between them run cubic Hermite polynomials, of the
/// position, and of the rotation vector that leads from one orientation to the next.
class KeyframeMotion {
 public:
  /// Throws std::invalid_argument unless there are keyframes and their times ascend strictly.
  KeyframeMotion(const std::vector<Keyframe>& keyframes, Interpolation interpolation);

  RigidState at(double time) const;
  double end() const { return end_; }  // [s] the last keyframe

 private:
  /// Between two keyframes; s goes from 0 to 1. Vectors of rotation are in the frame of the first one.
  struct Segment {
    double start = 0.0;     // [s]
    double duration = 0.0;  // [s]
    Pose from;
    Vec3 step;           // [m] from the first position to the second
    Vec3 turn;           // [rad] rotation vector from the first orientation to the second
    Vec3 step_rates[2];  // [m] d/ds of the position at both ends
    Vec3 turn_rates[2];  // [rad] d/ds of the rotation vector at both ends
  };

  std::vector<Segment> segments_;
  double end_ = 0.0;  // [s] the last keyframe
  Pose first_;
  Pose last_;
};

using Motion = std::variant<UniformMotion, SpinMotion, KeyframeMotion>;

/// Nothing moves after this time; -infinite if nothing ever does. [s]
double moves_until(const Motion& motion);

/// The state at a time [s].
inline RigidState at(const Motion& motion, double time) {
  return std::visit([time](const auto& m) { return m.at(time); }, motion);
}

}  // namespace sandsim::objects
