// What the command line says, as plain values: filled in by app.cpp, read by the commands.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "solver/device.hpp"

namespace sandsim::cli {

struct RunArguments {
  std::string scene;                   // file, or folder that holds a scene.yaml
  std::string output;                  // directory; empty: results/NAME
  std::vector<std::string> overrides;  // "a.b=v", in the order given
  std::optional<std::string> precision;
  Device device = Device::automatic;
  int threads = 0;  // 0: all
  bool resume = false;
  bool overwrite = false;
  double max_wall = 0.0;  // [s] 0: no limit
  bool json = false;
  bool quiet = false;
  bool verbose = false;
  int progress_fd = -1;      // descriptor to which progress is written for the process that started this one; -1: none
  std::string command_line;  // all of it, for the record
  std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now();  // of the command
};

struct CheckArguments {
  std::string scene;
  std::vector<std::string> overrides;
};

struct InfoArguments {
  std::string result;
};

struct SchemaArguments {
  bool reference = false;  // the Markdown page instead of the JSON Schema
};

struct BenchArguments {
  Device device = Device::cpu;  // cpu or cuda
  std::optional<int> size;      // cells along each side; absent: what suits the device
  int threads = 0;              // 0: all
  int repeats = 5;
  std::optional<std::string> precision;  // absent: both
  bool quick = false;                    // small and short: shows that it works, measures little
  bool json = false;
};

struct StudyArguments {
  std::string study;           // file, or folder that holds a study.yaml
  std::string output;          // directory; empty: results/study_NAME
  std::optional<int> repeats;  // absent: the study's
  std::vector<double> under;   // empty: the study's
  bool shortest = false;       // the shortest repeat instead of the study's choice
  bool quick = false;          // one repeat, the three coarsest spacings
  bool list = false;           // print the settings, run nothing
  bool overwrite = false;
  bool quiet = false;
};

}  // namespace sandsim::cli
