// Runs a scene twice and measures what the criteria look at.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/stress/criteria.hpp"
#include "cli/stress/stress_case.hpp"
#include "solver/device.hpp"

namespace sandsim::cli {

/// A scheme with its order and precision, in which every case is run.
struct Variant {
  std::string scheme;  // "paper" or "balanced"
  int order = 0;       // 0 with the paper's
  Precision precision = Precision::float32;

  const char* precision_name() const { return precision == Precision::float32 ? "float32" : "float64"; }
  /// "balanced order 2".
  std::string name() const;
  /// "balanced2_float32": a part of a file name.
  std::string file_name() const;
  /// For read_scene().
  std::vector<std::string> overrides() const;
};

/// The paper's scheme and the balanced one of both orders, each in both precisions.
std::vector<Variant> all_variants();

/// A scene file and all that is needed to judge it.
struct Trial {
  std::filesystem::path scene;
  Variant variant;
  Criteria criteria;
  double step_in_bounds = 0.0;  // see StressCase
};

struct MeasureOptions {
  Device device = Device::cpu;  // cpu or cuda
  double max_wall = 0.0;        // [s] of a run; 0: no limit
};

/// The scene of a trial, ready to run: its variant is set, meshes are baked, fixed steps have their length.
Scene trial_scene(const Trial& trial);

/// Never throws: what a run would end with is in the exit code and message.
Measurement measure(const Trial& trial, const MeasureOptions& options);

}  // namespace sandsim::cli
