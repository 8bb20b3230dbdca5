// Sweep files: a scene and what varies in it.
#pragma once

#include <filesystem>

#include "io/sweep/plan.hpp"

namespace sandsim {

/// True if a file describes a sweep and not a scene: it names one (`scene:`). False if it cannot be read or is no
/// YAML, so that whoever reads the scene says so.
bool is_sweep_file(const std::filesystem::path& file);

/// Reads
///   scene: scene.yaml                       # relative to this file
///   set: {time.end: 2 s}                    # may be left out, as all below
///   vary:                                   # a map: all combinations
///     sand.friction_angle: 20:40:8 deg      # as in --vary
///     sand.hbar.scale: [0.2, 0.4]           # or a list of YAML
///   # a list of maps: the keys of each map vary together
///   samples: 64
///   sampling: latin                         # or random
///   seed: 1
/// Throws SceneError with all problems, InputError if the file cannot be read.
SweepPlan read_sweep(const std::filesystem::path& file);

}  // namespace sandsim
