#include "solver/objects/motion.hpp"

#include <numbers>
#include <stdexcept>

#include "tests/objects/support.hpp"

using namespace sandsim::objects;
using namespace sandsim::test;

namespace {

constexpr double pi = std::numbers::pi;

// Poses of about 1 m and a few turns, a hundred operations: 1e-12 is the precision that is asked for.
constexpr double precise = 1e-12;

/// The velocities of a motion as differences of its poses, by Richardson's extrapolation from h and h/2.
RigidState differences(const Motion& motion, double time) {
  const auto rate = [&](double h) {
    const Pose before = at(motion, time - h).pose;
    const Pose after = at(motion, time + h).pose;
    const Vec3 turn = logarithm(after.orientation * inverse(before.orientation));
    return RigidState{{}, (0.5 / h) * (after.position - before.position), (0.5 / h) * turn};
  };
  const RigidState coarse = rate(1e-3);
  const RigidState fine = rate(5e-4);
  const auto extrapolated = [](const Vec3& f, const Vec3& c) { return (4.0 / 3.0) * f - (1.0 / 3.0) * c; };
  return {
      {}, extrapolated(fine.velocity, coarse.velocity), extrapolated(fine.angular_velocity, coarse.angular_velocity)};
}

void check_derivatives(const Motion& motion, double time) {
  const RigidState exact = at(motion, time);
  const RigidState found = differences(motion, time);
  CAPTURE(time);
  // Rounding of the positions over a step of 5e-4, and the fifth derivative times 1e-12.
  CHECK(difference(exact.velocity, found.velocity) < 2e-10);
  CHECK(difference(exact.angular_velocity, found.angular_velocity) < 2e-10);
}

std::vector<Keyframe> random_keyframes(Random& random, int count) {
  std::vector<Keyframe> keyframes;
  double time = 0.0;
  for (int k = 0; k < count; ++k) {
    keyframes.push_back({time, random.pose(1.0)});
    time += random.between(0.5, 2.0);
  }
  return keyframes;
}

}  // namespace

TEST_CASE("a uniform motion starts at its pose and goes on evenly") {
  const UniformMotion motion{{{{1, 2, 3}, {}}, {0.1, 0, -0.2}, {0, 0, pi}}, 2.0};
  const RigidState state = motion.at(2.5);
  CHECK(difference(state.pose.position, {1.05, 2, 2.9}) < precise);
  CHECK(difference(state.pose.orientation, from_axis_angle({0, 0, 1}, 0.5 * pi)) < precise);
  CHECK(difference(state.velocity, {0.1, 0, -0.2}) == 0.0);
  CHECK(difference(state.velocity_at(state.pose.position + Vec3{1, 0, 0}), {0.1, pi, -0.2}) < precise);
}

TEST_CASE("a spin turns about its centre") {
  const SpinMotion motion{{{2, 0, 0}, {}}, 0.0, {1, 0, 0}, {0, 0, 2 * pi}};
  const RigidState quarter = motion.at(0.25);
  CHECK(difference(quarter.pose.position, {1, 1, 0}) < precise);
  CHECK(difference(quarter.velocity, {-2 * pi, 0, 0}) < precise);
  CHECK(difference(motion.at(1000.0).pose.position, {2, 0, 0}) < precise);
  CHECK(difference(quarter.velocity_at(motion.center), {0, 0, 0}) < precise);
}

TEST_CASE("linear keyframes are met and joined evenly") {
  const KeyframeMotion motion({{1, {{0, 0, 0}, {}}}, {3, {{4, 0, 2}, from_axis_angle({0, 1, 0}, 0.5 * pi)}}},
                              Interpolation::linear);
  const RigidState middle = motion.at(2.0);
  CHECK(difference(middle.pose.position, {2, 0, 1}) < precise);
  CHECK(difference(middle.velocity, {2, 0, 1}) < precise);
  CHECK(difference(middle.pose.orientation, from_axis_angle({0, 1, 0}, 0.25 * pi)) < precise);
  CHECK(difference(middle.angular_velocity, {0, 0.25 * pi, 0}) < precise);
  CHECK(difference(motion.at(0.0).velocity, {0, 0, 0}) == 0.0);
  CHECK(difference(motion.at(3.0).velocity, {0, 0, 0}) == 0.0);
  CHECK(difference(motion.at(9.0).pose.position, {4, 0, 2}) == 0.0);
}

TEST_CASE("between two orientations the shorter way is taken") {
  const Quaternion turned = from_axis_angle({0, 0, 1}, 0.5 * pi);
  const Quaternion same{-turned.w, -turned.x, -turned.y, -turned.z};
  const KeyframeMotion motion({{0, {}}, {1, {{}, same}}}, Interpolation::linear);
  CHECK(difference(motion.at(0.5).angular_velocity, {0, 0, 0.5 * pi}) < precise);
}

TEST_CASE("every keyframe is met by both interpolations") {
  Random random;
  const std::vector<Keyframe> keyframes = random_keyframes(random, 7);
  for (const Interpolation interpolation : {Interpolation::linear, Interpolation::cubic}) {
    const KeyframeMotion motion(keyframes, interpolation);
    for (const Keyframe& k : keyframes) {
      for (const double time : {k.time - 1e-14, k.time}) {
        CHECK(difference(motion.at(time).pose.position, k.pose.position) < precise);
        CHECK(difference(motion.at(time).pose.orientation, k.pose.orientation) < precise);
      }
    }
  }
}

TEST_CASE("cubic keyframes reproduce motions of second order") {
  const auto position = [](double t) { return Vec3{1 + 2 * t - t * t, 0.5 * t * t, -t}; };
  const auto velocity = [](double t) { return Vec3{2 - 2 * t, t, -1}; };
  const auto angle = [](double t) { return 0.3 * t + 0.2 * t * t; };
  const Vec3 axis{0.6, 0, 0.8};
  std::vector<Keyframe> keyframes;
  for (const double t : {0.0, 0.5, 1.2, 2.0, 3.0}) {
    keyframes.push_back({t, {position(t), from_axis_angle(axis, angle(t))}});
  }
  const KeyframeMotion motion(keyframes, Interpolation::cubic);
  for (double t = 0.0; t < 3.0; t += 0.07) {
    const RigidState state = motion.at(t);
    CAPTURE(t);
    CHECK(difference(state.pose.position, position(t)) < precise);
    CHECK(difference(state.velocity, velocity(t)) < precise);
    CHECK(difference(state.pose.orientation, from_axis_angle(axis, angle(t))) < precise);
    CHECK(difference(state.angular_velocity, (0.3 + 0.4 * t) * axis) < precise);
  }
}

TEST_CASE("velocities are the derivatives of the pose") {
  Random random;
  const std::vector<Keyframe> keyframes = random_keyframes(random, 6);
  const std::vector<Motion> motions{
      UniformMotion{{random.pose(1), random.vector(1), random.vector(3)}, 0.0},
      SpinMotion{random.pose(1), 0.0, random.vector(1), random.vector(3)},
      KeyframeMotion(keyframes, Interpolation::linear),
      KeyframeMotion(keyframes, Interpolation::cubic),
  };
  for (const Motion& motion : motions) {
    // Inside the keyframes' intervals, at least 2e-3 s from their ends.
    for (std::size_t k = 0; k + 1 < keyframes.size(); ++k) {
      for (const double part : {0.01, 0.3, 0.5, 0.9, 0.99}) {
        check_derivatives(motion, keyframes[k].time + part * (keyframes[k + 1].time - keyframes[k].time));
      }
    }
  }
}

TEST_CASE("velocities are continuous at the inner keyframes of a cubic motion") {
  Random random;
  const std::vector<Keyframe> keyframes = random_keyframes(random, 6);
  const KeyframeMotion motion(keyframes, Interpolation::cubic);
  for (std::size_t k = 1; k + 1 < keyframes.size(); ++k) {
    const RigidState before = motion.at(keyframes[k].time - 1e-13);
    const RigidState after = motion.at(keyframes[k].time);
    // Accelerations of up to 30 m/s^2 over 1e-13 s.
    CHECK(difference(before.velocity, after.velocity) < 1e-11);
    CHECK(difference(before.angular_velocity, after.angular_velocity) < 1e-11);
  }
}

TEST_CASE("turning the whole scene turns the motion") {
  Random random;
  const Pose frame = random.pose(1.0);
  std::vector<Keyframe> keyframes = random_keyframes(random, 5);
  const KeyframeMotion plain(keyframes, Interpolation::cubic);
  for (Keyframe& k : keyframes) k.pose = frame * k.pose;
  const KeyframeMotion turned(keyframes, Interpolation::cubic);
  for (double t = 0.1; t < keyframes.back().time; t += 0.3) {
    const RigidState a = plain.at(t);
    const RigidState b = turned.at(t);
    CHECK(difference((frame * a.pose).position, b.pose.position) < precise);
    CHECK(difference((frame * a.pose).orientation, b.pose.orientation) < precise);
    CHECK(difference(rotate(frame.orientation, a.velocity), b.velocity) < precise);
    CHECK(difference(rotate(frame.orientation, a.angular_velocity), b.angular_velocity) < precise);
  }
}

TEST_CASE("one keyframe is a place to stay at, and two make a cubic motion even") {
  const KeyframeMotion one({{1, {{1, 2, 3}, {}}}}, Interpolation::cubic);
  CHECK(difference(one.at(7).pose.position, {1, 2, 3}) == 0.0);
  const KeyframeMotion two({{0, {}}, {2, {{4, 0, 0}, {}}}}, Interpolation::cubic);
  CHECK(difference(two.at(0.5).velocity, {2, 0, 0}) < precise);
}

TEST_CASE("keyframes out of order or none at all are refused") {
  CHECK_THROWS_AS(KeyframeMotion({}, Interpolation::linear), std::invalid_argument);
  CHECK_THROWS_AS(KeyframeMotion({{1, {}}, {1, {}}}, Interpolation::linear), std::invalid_argument);
  CHECK_THROWS_AS(KeyframeMotion({{2, {}}, {1, {}}}, Interpolation::cubic), std::invalid_argument);
}

TEST_CASE("rotations are what their numbers say") {
  const Vec3 x{1, 0, 0};
  CHECK(difference(rotate(from_axis_angle({0, 0, 2}, 0.5 * pi), x), {0, 1, 0}) < precise);
  CHECK(difference(rotate(from_euler(0, 0, 0.5 * pi), x), {0, 1, 0}) < precise);
  CHECK(difference(rotate(from_euler(0, 0.5 * pi, 0), x), {0, 0, -1}) < precise);
  // Roll first, yaw last: z goes to -y by the roll and on to x by the yaw.
  CHECK(difference(rotate(from_euler(0.5 * pi, 0, 0.5 * pi), {0, 0, 1}), x) < precise);
  CHECK_THROWS_AS(normalized(Quaternion{0, 0, 0, 0}), std::invalid_argument);
  CHECK(difference(normalized(Vec3{0, 3e-200, 4e-200}), {0, 0.6, 0.8}) < precise);
  CHECK(difference(normalized(Vec3{0, 3e200, 4e200}), {0, 0.6, 0.8}) < precise);
  CHECK_THROWS_AS(from_axis_angle({0, 0, 0}, 1.0), std::invalid_argument);
}

TEST_CASE("the logarithm undoes the exponential for small and large angles") {
  const Vec3 axis{0.48, -0.6, 0.64};
  for (const double angle : {0.0, 1e-12, 1e-5, 9.9e-3, 1.01e-2, 0.3, 0.51, 2.0, 3.1}) {
    CAPTURE(angle);
    CHECK(difference(logarithm(exponential(angle * axis)), angle * axis) < precise);
  }
}

TEST_CASE("rates of rotation vectors and angular velocities are inverse to each other") {
  Random random;
  for (const double angle : {0.0, 1e-6, 9e-3, 0.09, 0.11, 0.49, 0.51, 1.0, 3.0}) {
    const Vec3 v = angle * Vec3{0.48, -0.6, 0.64};
    const Vec3 rate = random.vector(1.0);
    CAPTURE(angle);
    CHECK(difference(inverse_body_rate(v, body_rate(v, rate)), rate) < precise);
  }
}
