#include "solver/device.hpp"

#include "solver/backends/cuda/cuda.hpp"
#include "solver/errors.hpp"

namespace sandsim {
namespace {

/// Below it a run on the CPU is over before a device is set up and its launches pay: a step of so many cells takes a
/// processor tens of microseconds, and a launch some of them.
constexpr std::size_t worthwhile_cells = 16384;

}  // namespace

DeviceChoice choose_device(Device wanted, const Grid& grid) {
  if (wanted == Device::cpu) {
    return {Device::cpu, "cpu", "asked for"};
  }
  if (wanted == Device::automatic && grid.cell_count() < worthwhile_cells) {
    return {Device::cpu, "cpu",
            "auto: fewer than " + std::to_string(worthwhile_cells) + " cells are not worth a CUDA device"};
  }
  const CudaSurvey survey = survey_cuda();
  if (survey.problem.empty()) {
    const std::string name = "cuda (" + survey.name + ")";
    return {Device::cuda, name, wanted == Device::cuda ? "asked for" : "auto: there is one"};
  }
  if (wanted == Device::cuda) {
    throw DeviceError("--device cuda: " + survey.problem);
  }
  return {Device::cpu, "cpu", "auto: " + survey.problem.substr(0, survey.problem.find(". "))};
}

}  // namespace sandsim
