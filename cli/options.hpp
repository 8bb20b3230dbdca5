// What the command line says, as plain values: filled in by app.cpp, read by the commands.
#pragma once

#include <chrono>
#include <cstdint>
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
  int threads = 0;  // 0: as many as are free and pay
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

struct SweepArguments {
  std::string scene;                   // scene, sweep file, folder with either, or output directory of a sweep
  std::vector<std::string> vary;       // "key=values", in the order given
  std::vector<std::string> overrides;  // "a.b=v", for all cases
  std::optional<int> samples;
  std::optional<std::string> sampling;  // "latin" or "random"
  std::optional<std::uint64_t> seed;
  std::string output;  // directory; empty: results/NAME_sweep
  int parallel = 0;    // cases at a time; 0: as many as there are processors for
  int threads = 0;     // of a case; 0: what is left over for it
  Device device = Device::automatic;
  std::optional<std::string> precision;
  double max_wall = 0.0;  // [s] 0: no limit
  bool yes = false;
  bool retry = false;
  bool skip_invalid = false;
  bool overwrite = false;
  bool list = false;
  bool expand = false;
  bool collect = false;
  std::optional<int> one_case;  // from 1
  bool quiet = false;
  std::string command_line;  // all of it, for the record
};

struct FitArguments {
  std::string scene;                   // file, or folder that holds a scene.yaml
  std::vector<std::string> vary;       // "key=first:last", in the order given
  std::vector<std::string> overrides;  // "a.b=v", for all runs
  std::string front;                   // CSV of a front over time; empty: none
  std::string profile;                 // CSV of a profile
  std::string run;                     // results folder
  std::optional<std::string> at;       // time of the profile; absent: the end of the scene
  std::optional<std::string> front_depth;
  std::optional<std::string> tolerance;  // how well the data are known; absent: 1 % of the signal
  std::string output;                    // directory; empty: results/NAME_fit
  int parallel = 0;                      // runs at a time; 0: as many as there are processors
  int evaluations = 0;                   // runs that the search may take; 0: 60 a parameter
  int map = 11;                          // points along each side of the map; 0: no map
  std::uint64_t seed = 1;
  bool yes = false;
  bool overwrite = false;
  bool quiet = false;
  std::string command_line;  // all of it, for the record
};

struct InfoArguments {
  std::string result;
};

struct ExportArguments {
  std::string result;
  std::string what = "surface";       // or terrain, particles, level-set, rasters
  std::vector<std::string> fields;    // of rasters; empty: all
  std::optional<std::string> format;  // absent: that of `output`, or the first that `what` has
  std::optional<int> frame;           // from 0, or from the end below 0; absent: the last
  std::optional<std::string> time;    // of the frame, "2 s"
  bool all = false;                   // frames
  std::string output;                 // file, with `all` a folder; empty: WHAT in the result's folder
  bool overwrite = false;
  std::optional<std::string> iso;   // depth at which the sand is clipped; absent: 0.1 cells
  bool closed = false;              // the mesh, by the ground and upright sides
  std::optional<std::string> cell;  // spacing of a level set; absent: 0.5 cells
  std::optional<std::string> band;  // about its surface; absent: 4 spacings
  bool json = false;
  bool quiet = false;
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

struct StressArguments {
  std::vector<std::string> scenes;  // empty: the built-in matrix
  std::string output = "results/stress";
  std::string only;             // part of the names of the cases to run
  int randoms = 200;            // scenes drawn at random
  Device device = Device::cpu;  // cpu or cuda
  int jobs = 0;                 // runs side by side; 0: all processors, one on a CUDA device
  double max_wall = 0.0;        // [s] of a run; 0: as the command has it
  bool quick = false;
  bool overwrite = false;
  std::string command_line;  // all of it, for the record
};

}  // namespace sandsim::cli
