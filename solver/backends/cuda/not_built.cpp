// In place of the CUDA backend, where there was no CUDA compiler.
#include "solver/backends/cuda/cuda.hpp"
#include "solver/errors.hpp"

namespace sandsim {

CudaSurvey survey_cuda() {
  CudaSurvey survey;
  survey.problem =
      "this sandsim was built without CUDA. Build it where nvcc is (cmake -DSANDSIM_CUDA=ON), or use --device cpu?";
  return survey;
}

std::unique_ptr<Backend> make_cuda_backend(const BackendConfig&, const InitialState&) {
  throw DeviceError(survey_cuda().problem);
}

std::unique_ptr<Ensemble> make_cuda_ensemble(const std::vector<EnsembleMember>&) {
  throw DeviceError(survey_cuda().problem);
}

}  // namespace sandsim
