// The CUDA backend as the rest of the program sees it, whether it was built in or not.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "solver/backend.hpp"
#include "solver/ensemble.hpp"

namespace sandsim {

/// What is known of the first CUDA device.
struct CudaSurvey {
  bool built_in = false;  // this program has a CUDA backend
  std::string problem;    // why no device can be used; empty: one can
  std::string name;
  int processors = 0;               // streaming multiprocessors
  int capability = 0;               // 10 major + minor
  int driver = 0, runtime = 0;      // 1000 major + 10 minor; driver 0: none
  std::size_t free = 0, total = 0;  // [B]
};
CudaSurvey survey_cuda();

/// Throws DeviceError if no device can be used, or its memory does not suffice.
std::unique_ptr<Backend> make_cuda_backend(const BackendConfig& config, const InitialState& initial);

}  // namespace sandsim
