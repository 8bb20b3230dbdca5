// The fine run that a study's errors are taken against.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/study/timed_runs.hpp"
#include "io/study/study_reader.hpp"

namespace sandsim::cli {

struct FineDepth {
  std::vector<double> depth;   // [m] ny * nx at the end
  std::filesystem::path file;  // that keeps it
  bool is_from_file = false;
  double seconds = 0.0;  // [s] that the run took; 0 if it was not needed
};

/// The depth at the end of a run, from `folder`/fine-HASH.npy if that is there and whole; else it is run with all
/// threads and written there. HASH is that of the scene, the files that it depends on, and this version of sandsim.
/// `options` has the interrupt. Throws Error with the code of a run that failed or was interrupted.
FineDepth fine_depth(const StudyRun& run, const std::filesystem::path& folder, const RoundOptions& options);

}  // namespace sandsim::cli
