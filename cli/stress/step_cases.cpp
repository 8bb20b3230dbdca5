#include <fmt/format.h>

#include "cli/stress/matrix.hpp"

namespace sandsim::cli {

namespace {

/// A stream whose stability bound stays what it is: uniform, periodic, without friction.
SceneText stream() {
  SceneText scene;
  scene.grid = "{cells: [32, 32], spacing: 1 cm}";
  scene.friction = "friction_angle: 0 deg";
  scene.initial = "{type: layer, depth: 5 cm, velocity: [2 m/s, 1 m/s]}";
  scene.boundaries = "{x_min: periodic, x_max: periodic, y_min: periodic, y_max: periodic}";
  scene.end = 0.2;
  return scene;
}

SceneText dam() {
  SceneText scene;
  scene.end = 0.4;
  return scene;
}

StressCase fixed(const std::string& name, const std::string& meaning, const SceneText& scene, double bounds) {
  StressCase made{name, meaning, scene};
  made.step_in_bounds = bounds;
  made.criteria.step = 0.0;  // given
  return made;
}

void refuse_long_step(StressCase& made) {
  made.criteria.ending = ExitCode::numerical_failure;
  made.criteria.message = "longer than the stability bound";
}

void add_fixed(std::vector<StressCase>& cases) {
  for (const double bounds : {0.1, 0.5, 0.99, 1.01, 2.0, 10.0}) {
    StressCase made = fixed(fmt::format("step_stream_{:g}", bounds),
                            fmt::format("a stream in fixed steps of {:g} stability bounds", bounds), stream(), bounds);
    if (bounds > 1.0) {
      refuse_long_step(made);
    }
    cases.push_back(made);
  }
  for (const double bounds : {0.1, 0.25, 2.0, 10.0}) {
    StressCase made = fixed(fmt::format("step_dam_{:g}", bounds),
                            fmt::format("a dam in fixed steps of {:g} stability bounds", bounds), dam(), bounds);
    if (bounds > 1.0) {
      refuse_long_step(made);
    }
    cases.push_back(made);
  }
  for (const double bounds : {2.0, 10.0}) {
    for (const auto& [name, scene] : {std::pair("stream", stream()), std::pair("dam", dam())}) {
      StressCase made =
          fixed(fmt::format("step_{}_{:g}_subcycled", name, bounds),
                fmt::format("a {} in fixed steps of {:g} stability bounds, divided", name, bounds), scene, bounds);
      made.scene.time = "mode: fixed, step: 0.01 s, subcycle: true";
      made.scene.frames = static_cast<int>(made.scene.end / 0.1);
      cases.push_back(made);
    }
  }
}

void add_courant(std::vector<StressCase>& cases) {
  for (const char* courant : {"0.01", "0.1", "0.5", "0.9", "1"}) {
    StressCase made{fmt::format("step_courant_{}", courant), fmt::format("a dam with a Courant number of {}", courant),
                    dam()};
    made.scene.time = fmt::format("courant: {}", courant);
    if (made.scene.time == "courant: 0.01") {
      made.criteria.step = 0.0003;  // a hundredth of the Courant number that the bound is for
    }
    cases.push_back(made);
  }
  StressCase refused{"step_refused_courant", "a Courant number of 2 is refused", dam()};
  refused.scene.time = "courant: 2";
  refused.criteria.ending = ExitCode::invalid_scene;
  refused.criteria.message = "time.courant";
  cases.push_back(refused);
}

void add_limits(std::vector<StressCase>& cases) {
  StressCase short_step{"step_below_minimum", "a dam whose stable step is below time.minimum_step is stopped", dam()};
  short_step.scene.time = "minimum_step: 50 ms";
  short_step.criteria.ending = ExitCode::numerical_failure;
  short_step.criteria.message = "below time.minimum_step";
  cases.push_back(short_step);
  StressCase rest{"step_rest_long", "sand at rest takes steps of a whole frame of 1e6 s", dam()};
  rest.scene.initial = "{type: layer, depth: 5 cm}";
  rest.scene.end = 1e7;
  rest.criteria.rest_kept = true;
  cases.push_back(rest);
  StressCase frames{"step_many_frames", "a thousand frames, shorter than the stable step", dam()};
  frames.scene.frames = 1000;
  frames.criteria.step = 0.0;  // frames cut the steps
  cases.push_back(frames);
}

}  // namespace

std::vector<StressCase> step_cases() {
  std::vector<StressCase> cases;
  add_fixed(cases);
  add_courant(cases);
  add_limits(cases);
  return cases;
}

}  // namespace sandsim::cli
