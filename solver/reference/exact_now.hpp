// The exact solution that a scene refers to, with the scene's own parameters, at one moment.
#pragma once

#include <functional>
#include <limits>
#include <string>

#include "solver/initial_state.hpp"
#include "solver/scene.hpp"

namespace sandsim {

/// What is known of an exact solution at one moment.
struct ExactNow {
  std::string name;                     // e.g. "Stoker's dam break"
  std::string problem;                  // why it does not apply to this scene or moment; empty if it does
  std::string limit;                    // what is not known of it; may be empty
  std::function<double(double)> depth;  // [m] at x [m], falling with x; empty if the profile is not known
  double from = -std::numeric_limits<double>::infinity();  // [m] the profile holds at larger x
  double tip = std::numeric_limits<double>::quiet_NaN();   // [m] of the tip, or the shock; NaN if unknown
};

/// The scene's reference.exact at `time` [s]; the scene must have one.
ExactNow exact_now(const Scene& scene, const InitialState& initial, double time);

}  // namespace sandsim
