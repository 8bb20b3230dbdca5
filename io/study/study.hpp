// A study: scenes, what is varied in them, and what their errors are taken against. Member names are the keys of the
// study file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/scene/node.hpp"
#include "solver/device.hpp"

namespace sandsim {

/// Values that replace those of a scene, by their keys as in --set: {numerics.order: 1, time.end: 2 s}.
struct Settings {
  std::vector<Node> entries;
};

/// Keys of a scene, each with a list of values that are tried in turn.
struct Variations {
  std::vector<Node> axes;
};

struct StudyScene {
  std::string name;  // empty: the file's name, or that of its folder
  std::string file;  // scene file, or a folder that holds a scene.yaml; relative to the study
  Settings set;
};

struct StudyMethod {
  std::string name;
  Settings set;
};

/// What an error is taken against: a reference of the scene, or the study's fine run.
enum class Against { exact, profile, measured_profile, measured_front, fine };
/// The error that decides: norms of the depth, the position of the front, the height of the deposit, the volume.
enum class ErrorMeasure { l1_relative, l1, l2, linf, front, height, volume };

/// Which of the repeats stands for all: the median, or the shortest, for a machine that is not idle.
enum class TimeChoice { median, shortest };

struct ErrorChoice {
  std::optional<Against> against;  // absent: the fine run if there is one, else the scene's first that applies
  ErrorMeasure measure = ErrorMeasure::l1_relative;
};

struct FineRun {
  double spacing = 0.0;  // [m]
  Settings set;
};

/// A scene and variants of it, timed side by side.
struct Ablation {
  std::string file;
  Settings set;
  std::string base = "base";  // name of the scene as it is
  std::vector<StudyMethod> variants;
  bool writes = false;  // frames go to a series.h5 as a run writes it, not nowhere
};

struct Study {
  std::string title;
  std::vector<StudyScene> scenes;
  Settings set;  // in all scenes, the ablation's excepted
  std::vector<double> spacings;
  std::vector<StudyMethod> methods;
  Variations vary;
  std::vector<Device> devices{Device::cpu};
  std::vector<int> threads{1};
  ErrorChoice error;
  std::optional<FineRun> fine;
  std::vector<double> under{1e-2};
  int repeats = 5;
  TimeChoice times = TimeChoice::median;
  std::optional<Ablation> ablation;
};

}  // namespace sandsim
