// In place of the measurements on a CUDA device, where there was no CUDA compiler.
#include "solver/backends/cuda/cuda.hpp"
#include "solver/backends/cuda/rates.hpp"
#include "solver/errors.hpp"

namespace sandsim {

CudaCopyRates measure_cuda_copies(std::size_t, int) {
  throw DeviceError(survey_cuda().problem);
}

CudaArithmeticRates measure_cuda_arithmetic(Precision, int) {
  throw DeviceError(survey_cuda().problem);
}

}  // namespace sandsim
