// What a CUDA device can do at best: the floors that its steps are judged by.
#pragma once

#include <cstddef>
#include <vector>

#include "solver/scene.hpp"

namespace sandsim {

/// One rate a repeat. Throws DeviceError if no device can be used, or its memory does not suffice.
struct CudaCopyRates {
  std::vector<double> runtime;  // [B/s] read + written, by the runtime's copy
  std::vector<double> kernel;   // [B/s] by a kernel that copies 16 bytes a thread
};
CudaCopyRates measure_cuda_copies(std::size_t array_bytes, int repeats);

/// Operations a second over the whole device, on values that stay in registers; a multiplication and an addition are
/// two operations, as everywhere in the solver. One rate a repeat. Throws DeviceError as above.
struct CudaArithmeticRates {
  std::vector<double> simple;   // additions and multiplications in equal parts
  std::vector<double> divided;  // divisions and square roots in equal parts
};
CudaArithmeticRates measure_cuda_arithmetic(Precision precision, int repeats);

}  // namespace sandsim
