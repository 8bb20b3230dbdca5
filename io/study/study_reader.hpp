// Study files into the runs that they ask for.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "io/study/study.hpp"
#include "solver/scene.hpp"

namespace sandsim {

/// One setting: a point of a curve.
struct StudyCase {
  std::size_t scene = 0;           // index in Study::scenes
  std::string method;              // empty without methods
  std::vector<std::string> picks;  // one value an axis of Study::vary, as written
  Device device = Device::cpu;
  int threads = 1;
  Scene setup;  // one frame, at the end, of the depth alone: frames would cut steps
};

/// A scene that is run, with the files that its result depends on.
struct StudyRun {
  std::string name;
  Scene setup;
  std::filesystem::path folder;  // of its relative file names
};

struct StudyPlan {
  Study study;                     // as in the file, names of scenes filled in and files absolute
  std::vector<StudyCase> cases;    // scene by scene, curve by curve, spacings in the order of the file
  std::vector<StudyRun> fine;      // one a scene; empty without Study::fine
  std::vector<StudyRun> variants;  // of the ablation, the base first; empty without one
};

/// Reads a study and every scene that it asks for. `change` may alter what the file says before it is expanded.
/// Throws SceneError with all problems, InputError if only files are missing.
StudyPlan read_study(const std::filesystem::path& file, const std::function<void(Study&)>& change = {});

/// The study as a file that gives the same plan from any folder.
std::string resolved_study(const Study& study);

/// A value on one line, as a file may write it.
std::string flow_text(const Node& node);

}  // namespace sandsim
