// Every call of the CUDA runtime is checked.
#pragma once

#include <cuda_runtime.h>

#include <string>

#include "solver/errors.hpp"

namespace sandsim::cuda {

/// Throws DeviceError: what was being done, and the runtime's own words.
inline void check(cudaError_t status, const char* doing) {
  if (status != cudaSuccess) {
    throw DeviceError(std::string("the CUDA device failed to ") + doing + ": " + cudaGetErrorString(status));
  }
}

}  // namespace sandsim::cuda
