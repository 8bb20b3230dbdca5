// A case of the stress matrix as plain data: a scene, what is extreme about it, and what its runs have to satisfy.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "solver/report.hpp"

namespace sandsim::cli {

/// Faces between cells at rest may stand this much above mu: the balanced scheme lets an excess of up to 1 % slide off
/// (solver/physics/balanced_flux.hpp), and first order leaves twice as much.
inline constexpr double resting_excess = 0.02;

/// What a run has to satisfy besides finite values, depths that are not negative, and the same bits when it is
/// repeated. Speeds are in units of the energy speed E = u0 + push + sqrt(g (H + rise)), where u0 is the fastest sand
/// at the start and H the height from the lowest bed to the highest sand.
struct Criteria {
  ExitCode ending = ExitCode::done;  // with which the run ends
  std::string message;               // part of what a run that is refused has to say
  double volume_float32 = 2e-6;      // largest |volume error|, relative
  double volume_float64 = 1e-13;
  /// Largest speed in E. A dam break's tip runs at 2 sqrt(g h); thin films, which carry no momentum, get to 4.8
  /// (tests/verification/robustness.cpp). 0: not judged.
  double speed = 5.0;
  /// Shortest step in dx/E. At the largest speed of 5 E along both axes the balanced scheme of order 2 takes
  /// 0.6/(4 x 5) = 0.03, the paper's 1/(4 x 6) = 0.04; frames cut steps in half. 0: not judged.
  double step = 0.015;
  bool stops = false;      // everything is at rest before the end, no face steeper than mu by more than resting_excess
  bool rest_kept = false;  // every depth and momentum is the same at the end
  double push = 0.0;       // [m/s] by objects
  double rise = 0.0;       // [m] by sources and objects
};

/// Values on the grid's cells that a scene names as a file: ny * nx, x fastest.
struct CaseRaster {
  std::string file;  // ends in .npy
  int nx = 0, ny = 0;
  std::vector<double> values;
};

/// The sections of a scene as YAML. `text()` puts them together.
struct SceneText {
  std::string grid = "{cells: [64, 1], spacing: 1 cm}";
  std::string gravity = "9.8 m/s^2";
  std::string terrain = "{type: flat}";
  std::string friction = "friction_angle: 30 deg";
  std::string hbar = "{policy: full}";
  std::string initial = "{type: box, from: [0 m, 0 m], to: [20 cells, 1 cells], depth: 10 cm}";
  std::string sources{};  // these three are left out where they are empty
  std::string boundaries{};
  std::string objects{};
  std::string time{};  // further keys of `time`, as "courant: 0.1"
  double end = 0.5;    // [s]
  int frames = 5;      // after the first one

  std::string text(const std::string& title) const;
};

/// A case's place in a stability map.
struct MapPlace {
  std::string map;
  double x = 0.0, y = 0.0;
};

struct StressCase {
  std::string name;     // also of its scene file
  std::string meaning;  // what is extreme about it
  SceneText scene;
  Criteria criteria{};
  std::string paper{};  // why the paper's scheme fails, in one line; empty: it has to pass like the balanced one
  std::vector<CaseRaster> rasters{};
  double step_in_bounds = 0.0;  // fixed steps of so many stability bounds of the initial state; 0: as the scene says
  std::string theme{};          // filled in by the matrix
  std::optional<MapPlace> place{};
};

}  // namespace sandsim::cli
