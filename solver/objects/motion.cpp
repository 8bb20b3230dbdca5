#include "solver/objects/motion.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "solver/objects/rotation.hpp"

namespace sandsim::objects {

RigidState UniformMotion::at(double time) const {
  const double elapsed = time - start_time;
  RigidState state = start;
  state.pose.position = start.pose.position + elapsed * start.velocity;
  state.pose.orientation = exponential(elapsed * start.angular_velocity) * start.pose.orientation;
  return state;
}

RigidState SpinMotion::at(double time) const {
  const Quaternion turn = exponential((time - start_time) * angular_velocity);
  const Vec3 arm = rotate(turn, start.position - center);
  return {{center + arm, turn * start.orientation}, cross(angular_velocity, arm), angular_velocity};
}

namespace {

/// Slopes at the knots of a curve whose pieces have these mean slopes and durations: each from the parabola through
/// three neighbouring knots.
std::vector<Vec3> knot_slopes(const std::vector<double>& durations, const std::vector<Vec3>& slopes) {
  const std::size_t pieces = slopes.size();
  std::vector<Vec3> result(pieces + 1);
  result.front() = slopes.front();
  result.back() = slopes.back();
  for (std::size_t k = 1; k < pieces; ++k) {
    const double before = durations[k - 1];
    const double after = durations[k];
    const Vec3 curvature = (1.0 / (before + after)) * (slopes[k] - slopes[k - 1]);
    result[k] = slopes[k - 1] + before * curvature;
    if (k == 1) result.front() = slopes.front() - before * curvature;
    if (k + 1 == pieces) result.back() = slopes.back() + after * curvature;
  }
  return result;
}

/// The cubic from 0 to `step` with these d/ds at both ends, and its d/ds.
struct Hermite {
  Vec3 value;
  Vec3 rate;
};

Hermite hermite(const Vec3& step, const Vec3 (&rates)[2], double s) {
  const double r = 1.0 - s;
  return {s * s * (3.0 - 2.0 * s) * step + s * r * r * rates[0] - s * s * r * rates[1],
          6.0 * s * r * step + r * (1.0 - 3.0 * s) * rates[0] + s * (3.0 * s - 2.0) * rates[1]};
}

}  // namespace

KeyframeMotion::KeyframeMotion(const std::vector<Keyframe>& keyframes, Interpolation interpolation) {
  if (keyframes.empty()) throw std::invalid_argument("a motion needs a keyframe");
  first_ = keyframes.front().pose;
  last_ = keyframes.back().pose;
  end_ = keyframes.back().time;
  std::vector<double> durations;
  std::vector<Vec3> velocities;
  std::vector<Vec3> turn_velocities;
  for (std::size_t k = 0; k + 1 < keyframes.size(); ++k) {
    const Keyframe& a = keyframes[k];
    const Keyframe& b = keyframes[k + 1];
    Segment segment{a.time,
                    b.time - a.time,
                    a.pose,
                    b.pose.position - a.pose.position,
                    logarithm(inverse(a.pose.orientation) * b.pose.orientation),
                    {},
                    {}};
    if (!(segment.duration > 0.0)) throw std::invalid_argument("the times of keyframes ascend");
    durations.push_back(segment.duration);
    velocities.push_back((1.0 / segment.duration) * segment.step);
    turn_velocities.push_back((1.0 / segment.duration) * segment.turn);
    segments_.push_back(segment);
  }
  if (segments_.empty()) return;
  const bool is_cubic = interpolation == Interpolation::cubic;
  const std::vector<Vec3> knot_velocities = knot_slopes(durations, velocities);
  // A turn has the same components in the frames at both of its ends, so that neighbouring ones can be averaged there.
  const std::vector<Vec3> knot_turns = knot_slopes(durations, turn_velocities);
  for (std::size_t k = 0; k < segments_.size(); ++k) {
    Segment& s = segments_[k];
    for (std::size_t end = 0; end < 2; ++end) {
      s.step_rates[end] = is_cubic ? s.duration * knot_velocities[k + end] : s.step;
      s.turn_rates[end] = is_cubic ? s.duration * knot_turns[k + end] : s.turn;
    }
    if (is_cubic) s.turn_rates[1] = inverse_body_rate(s.turn, s.turn_rates[1]);
  }
}

RigidState KeyframeMotion::at(double time) const {
  if (segments_.empty() || time < segments_.front().start) return {first_, {}, {}};
  if (time >= end_) return {last_, {}, {}};
  const auto after = std::upper_bound(segments_.begin(), segments_.end(), time,
                                      [](double t, const Segment& segment) { return t < segment.start; });
  const Segment& segment = *(after - 1);
  const double s = (time - segment.start) / segment.duration;
  const double per_second = 1.0 / segment.duration;
  const Hermite step = hermite(segment.step, segment.step_rates, s);
  const Hermite turn = hermite(segment.turn, segment.turn_rates, s);
  const Quaternion orientation = segment.from.orientation * exponential(turn.value);
  return {{segment.from.position + step.value, orientation},
          per_second * step.rate,
          per_second * rotate(orientation, body_rate(turn.value, turn.rate))};
}

double moves_until(const Motion& motion) {
  constexpr double always = std::numeric_limits<double>::infinity();
  if (const auto* uniform = std::get_if<UniformMotion>(&motion)) {
    const bool moves = length(uniform->start.velocity) > 0.0 || length(uniform->start.angular_velocity) > 0.0;
    return moves ? always : -always;
  }
  if (const auto* spin = std::get_if<SpinMotion>(&motion)) {
    return length(spin->angular_velocity) > 0.0 ? always : -always;
  }
  return std::get<KeyframeMotion>(motion).end();
}

}  // namespace sandsim::objects
