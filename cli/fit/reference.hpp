// What a fit compares runs with: a front over time, or a profile of depths at one time.
#pragma once

#include <string>
#include <vector>

#include "cli/options.hpp"
#include "solver/scene.hpp"

namespace sandsim::cli {

struct FitReference {
  enum class Kind { front, profile };

  Kind kind = Kind::front;
  std::string source;         // a file, or what the scene names
  std::vector<double> place;  // front: times [s]; profile: positions [m]; ascending, all within the run
  std::vector<double> value;  // [m] front: its position; profile: the depth
  double front_depth = 0.0;   // [m] front: the depth that defines it
  double time = 0.0;          // [s] at which runs may end: the last that is asked for
  double signal = 0.0;        // [m] front: how far it travels; profile: the largest depth
  std::vector<std::string> warnings;

  /// "front of 40 points from front.csv (where the depth crosses 5 mm)".
  std::string description() const;
  /// "travel of the front" or "largest depth": what the signal is.
  const char* signal_name() const;
};

/// The reference that the arguments name, else the scene's own: its measured front, its measured profile, its exact
/// solution (with the scene's values as they are), its profile, whichever is there first. Points that no run can reach
/// are left out with a warning. Throws InputError if none is left or a file cannot be read, Error with exit code 1 for
/// options that do not go together, SceneError for a scene without a reference.
FitReference read_fit_reference(const FitArguments& arguments, const Scene& scene);

}  // namespace sandsim::cli
