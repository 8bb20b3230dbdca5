// A sweep as its cases: what each changes in the scene, and the folder that its results have.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/sweep/plan.hpp"

namespace sandsim::cli {

/// One case. Cases are numbered from 1 for people.
struct SweepCase {
  std::vector<std::string> values;  // of the keys that vary, in their order
  std::string folder;               // of its results, relative to the sweep's: cases/HASH
  std::string scene_hash;           // as in run.json; empty for an invalid case
  std::string problem;              // what is wrong with the scene; empty: nothing
};

struct Sweep {
  std::filesystem::path scene;         // its file
  std::vector<std::string> overrides;  // for all cases
  std::vector<std::string> keys;       // that vary
  std::vector<SweepCase> cases;
  std::vector<std::string> warnings;  // about the scenes, each once

  /// What `--set` would have to say for a case.
  std::vector<std::string> overrides_of(const SweepCase& one) const;
  /// "sand.friction_angle=20 deg, sand.hbar.scale=0.3".
  std::string description_of(const SweepCase& one) const;
};

/// Reads the scene of a case: fills in its folder, a hash over the resolved scene, the bytes of all input files and of
/// the references that are there, so that nothing that could change its results or errors goes unseen. A scene that
/// is invalid becomes the case's problem. Throws InputError for files that are missing.
SweepCase resolve_case(const Sweep& sweep, const std::vector<std::string>& values,
                       std::vector<std::string>* warnings = nullptr);

/// All cases of the plan; two that come to the same scene are one too many: throws SceneError.
Sweep resolve_sweep(const SweepPlan& plan);

/// The first problems of the invalid cases, one a line, as of "--vary key=value"; empty if all are valid.
std::string problems_of(const Sweep& sweep);

}  // namespace sandsim::cli
