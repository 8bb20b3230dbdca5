#include <cuda_runtime.h>

#include <cstdlib>
#include <string>

#include "solver/backends/cuda/cuda.hpp"

namespace sandsim {
namespace {

__global__ void do_nothing() {}

std::string version(int number) {
  return std::to_string(number / 1000) + "." + std::to_string(number % 1000 / 10);
}

/// Why the runtime finds no device.
std::string missing_device(cudaError_t status, const CudaSurvey& survey) {
  if (survey.driver == 0) {
    return "no CUDA driver is installed (libcuda.so was not found). Install NVIDIA's driver, or use --device cpu?";
  }
  if (status == cudaErrorInsufficientDriver) {
    return "the CUDA driver is too old: it speaks CUDA " + version(survey.driver) + ", and this sandsim needs " +
           version(survey.runtime) + ". Update NVIDIA's driver, or use --device cpu?";
  }
  const char* visible = std::getenv("CUDA_VISIBLE_DEVICES");
  if (visible != nullptr && (status == cudaErrorNoDevice || status == cudaSuccess)) {
    return std::string("no CUDA device is visible: CUDA_VISIBLE_DEVICES is '") + visible +
           "'. Unset it, or use --device cpu?";
  }
  return std::string("no CUDA device can be used: ") +
         (status == cudaSuccess ? "there is none" : cudaGetErrorString(status)) + ". Use --device cpu?";
}

}  // namespace

CudaSurvey survey_cuda() {
  CudaSurvey survey;
  survey.built_in = true;
  cudaDriverGetVersion(&survey.driver);
  cudaRuntimeGetVersion(&survey.runtime);
  int count = 0;
  cudaError_t status = cudaGetDeviceCount(&count);
  if (status != cudaSuccess || count == 0) {
    survey.problem = missing_device(status, survey);
    return survey;
  }
  cudaDeviceProp properties;
  status = cudaGetDeviceProperties(&properties, 0);
  if (status == cudaSuccess) {
    survey.name = properties.name;
    survey.processors = properties.multiProcessorCount;
    survey.capability = 10 * properties.major + properties.minor;
    status = cudaMemGetInfo(&survey.free, &survey.total);
  }
  cudaFuncAttributes attributes;
  if (status == cudaSuccess) {
    status = cudaFuncGetAttributes(&attributes, do_nothing);
  }
  if (status == cudaErrorNoKernelImageForDevice || status == cudaErrorInvalidDeviceFunction) {
    survey.problem = survey.name + " has compute capability " + std::to_string(survey.capability / 10) + "." +
                     std::to_string(survey.capability % 10) +
                     ", for which this sandsim was not compiled. Build it with -DCMAKE_CUDA_ARCHITECTURES=" +
                     std::to_string(survey.capability) + ", or use --device cpu?";
  } else if (status != cudaSuccess) {
    survey.problem =
        std::string("the CUDA device cannot be used: ") + cudaGetErrorString(status) + ". Use --device cpu?";
  }
  return survey;
}

}  // namespace sandsim
