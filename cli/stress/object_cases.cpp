#include <fmt/format.h>

#include "cli/stress/matrix.hpp"

namespace sandsim::cli {

namespace {

/// A bed of sand, 6 cm deep, that one object meets.
StressCase meet(const std::string& name, const std::string& meaning, const std::string& object, double end,
                double speed) {
  StressCase made{name, meaning, {}};
  made.scene.grid = "{cells: [32, 32], spacing: 1 cm}";
  made.scene.initial = "{type: layer, depth: 6 cm}";
  made.scene.objects = fmt::format("[{{name: body, {}}}]", object);
  made.scene.end = end;
  made.criteria.push = speed;
  made.criteria.rise = 0.32;  // sand heaps up before an object, to no more than a bed's length
  return made;
}

void add_couplings(std::vector<StressCase>& cases) {
  for (const char* coupling : {"displace", "drag", "solid"}) {
    cases.push_back(meet(fmt::format("object_fast_{}", coupling),
                         fmt::format("a ball at 100 m/s through the sand, {}", coupling),
                         fmt::format("shape: {{type: sphere, radius: 3 cm}}, position: [5 cm, 16 cm, 4 cm], motion: "
                                     "{{type: constant, velocity: [100 m/s, 0 m/s, 0 m/s]}}, coupling: {}",
                                     coupling),
                         2e-3, 100.0));
    cases.push_back(
        meet(fmt::format("object_spinning_{}", coupling), fmt::format("a blade at 6000 rpm in the sand, {}", coupling),
             fmt::format("shape: {{type: box, size: [20 cm, 2 cm, 20 cm]}}, position: [16 cm, 16 cm, 5 cm], "
                         "motion: {{type: spin, rate: 6000 rpm}}, coupling: {}",
                         coupling),
             0.02, 63.0));
    cases.push_back(
        meet(fmt::format("object_jump_{}", coupling), fmt::format("a ball that jumps 20 cm within 1 us, {}", coupling),
             fmt::format("shape: {{type: sphere, radius: 3 cm}}, coupling: {}, motion: {{type: keyframes, "
                         "keyframes: [{{time: 0 s, position: [6 cm, 16 cm, 4 cm]}}, {{time: 10 ms, position: "
                         "[6 cm, 16 cm, 4 cm]}}, {{time: 10.001 ms, position: [26 cm, 16 cm, 4 cm]}}]}}",
                         coupling),
             0.05, 2e5));
    cases.push_back(meet(fmt::format("object_tiny_{}", coupling),
                         fmt::format("a ball of a tenth of a cell at 1 m/s, {}", coupling),
                         fmt::format("shape: {{type: sphere, radius: 1 mm}}, position: [5 cm, 16 cm, 5.95 cm], motion: "
                                     "{{type: constant, velocity: [1 m/s, 0 m/s, 0 m/s]}}, coupling: {}",
                                     coupling),
                         0.2, 1.0));
    cases.push_back(meet(fmt::format("object_huge_{}", coupling),
                         fmt::format("a ball of 3 m comes down on all of the sand at 1 m/s, {}", coupling),
                         fmt::format("shape: {{type: sphere, radius: 3 m}}, position: [16 cm, 16 cm, 3.1 m], motion: "
                                     "{{type: constant, velocity: [0 m/s, 0 m/s, -1 m/s]}}, coupling: {}, end: 80 ms",
                                     coupling),
                         0.15, 1.0));
  }
}

void add_odd(std::vector<StressCase>& cases) {
  cases.push_back(meet("object_appears", "a box appears within the sand and goes again",
                       "shape: {type: box, size: [10 cm, 10 cm, 10 cm]}, position: [16 cm, 16 cm, 4 cm], start: 20 ms, "
                       "end: 60 ms",
                       0.2, 0.0));
  cases.push_back(meet("object_under_bed", "a ball that moves under the bed meets no sand",
                       "shape: {type: sphere, radius: 3 cm}, position: [5 cm, 16 cm, -10 cm], motion: {type: constant, "
                       "velocity: [1 m/s, 0 m/s, 0 m/s]}",
                       0.2, 1.0));
  cases.back().criteria.rest_kept = true;
  cases.push_back(meet("object_at_rest", "a box that stands in the sand from the start, solid",
                       "shape: {type: box, size: [8 cm, 8 cm, 20 cm]}, position: [16 cm, 16 cm, 0 m], coupling: solid",
                       0.2, 0.0));
  cases.back().criteria.rest_kept = true;
  cases.back().paper = central_difference;
  cases.push_back(
      meet("object_meeting", "two plates that clap together at 1 m/s each",
           "shape: {type: box, size: [2 cm, 20 cm, 20 cm]}, position: [8 cm, 16 cm, 5 cm], motion: {type: "
           "constant, velocity: [1 m/s, 0 m/s, 0 m/s]}}, {name: other, shape: {type: box, size: [2 cm, 20 "
           "cm, 20 cm]}, position: [24 cm, 16 cm, 5 cm], motion: {type: constant, velocity: [-1 m/s, 0 m/s, "
           "0 m/s]}",
           0.1, 1.0));
  cases.push_back(meet("object_against_wall", "a plate sweeps all sand against a wall at 1 m/s",
                       "shape: {type: box, size: [2 cm, 40 cm, 40 cm]}, position: [2 cm, 16 cm, 5 cm], motion: {type: "
                       "constant, velocity: [1 m/s, 0 m/s, 0 m/s]}",
                       0.25, 1.0));
  cases.push_back(meet("object_frictionless", "a ball at 1 m/s through sand without friction",
                       "shape: {type: sphere, radius: 3 cm}, position: [5 cm, 16 cm, 4 cm], motion: {type: constant, "
                       "velocity: [1 m/s, 0 m/s, 0 m/s]}",
                       0.2, 1.0));
  cases.back().scene.friction = "friction_angle: 0 deg";
}

}  // namespace

std::vector<StressCase> object_cases() {
  std::vector<StressCase> cases;
  add_couplings(cases);
  add_odd(cases);
  return cases;
}

}  // namespace sandsim::cli
