// Small scenes and a sink that keeps what it is given.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "solver/errors.hpp"
#include "solver/initial_state.hpp"
#include "solver/simulation.hpp"

namespace sandsim::test {

/// Keeps every frame in memory.
class MemorySink : public Sink {
 public:
  void begin(const Scene&, const StaticFields& fields) override { statics = fields, begun += 1; }
  void frame(Frame frame) override { frames.push_back(std::move(frame)); }
  void end(const FinalFields& fields) override { finals = fields, ended += 1; }

  int begun = 0, ended = 0;
  StaticFields statics;
  std::vector<Frame> frames;
  FinalFields finals;
};

/// A block of sand at x < 0.4 m, 0.2 m deep, on a flat bed with walls: nx cells of 1/40 m, 30.9 deg, 1 s.
inline Scene collapse(int nx, int ny, Precision precision) {
  Scene scene;
  scene.title = "collapse";
  scene.grid.cells = {nx, ny};
  scene.grid.spacing = 0.025;
  scene.sand.friction_coefficient = 0.5985;
  SandBox box;
  box.to = {0.4, ny * 0.025};
  box.fill.depth = 0.2;
  scene.sand.initial = {box};
  scene.time.end = 1.0;
  scene.time.frame_interval = 0.1;
  scene.numerics.precision = precision;
  return scene;
}

inline const FieldValues& field_of(const Frame& frame, const std::string& name) {
  for (const NamedField& field : frame.fields) {
    if (field.name == name) {
      return field.values;
    }
  }
  throw std::out_of_range("no field " + name);
}

/// What building the initial state of a scene with problems says.
inline std::string initial_error(const Scene& scene) {
  try {
    build_initial_state(scene);
  } catch (const SceneError& problem) {
    return problem.what();
  }
  return "no error";
}

}  // namespace sandsim::test
