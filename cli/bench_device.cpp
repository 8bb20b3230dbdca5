#include "cli/bench_device.hpp"

#include <fmt/format.h>

#include "cli/copy_bandwidth.hpp"
#include "cli/machine.hpp"
#include "solver/backends/cuda/cuda.hpp"
#include "solver/backends/cuda/rates.hpp"
#include "solver/errors.hpp"

namespace sandsim::cli {

BenchDevice cpu_bench_device(int threads) {
  BenchDevice device;
  device.name = processor_name();
  device.details =
      fmt::format("{}, {} thread{}, {}", device.name, threads, threads == 1 ? "" : "s", vector_instructions());
  device.copies = "ordinary stores";
  device.threads = threads;
  device.steps_at_once = 4e7;
  device.copy_bandwidth = [threads](std::size_t bytes, int repeats) {
    return measure_copy_bandwidth(bytes, threads, repeats);
  };
  device.arithmetic = [threads](Precision precision, int repeats) {
    return measure_arithmetic(precision, threads, repeats);
  };
  device.make = make_cpu_backend;
  return device;
}

BenchDevice cuda_bench_device() {
  const CudaSurvey survey = survey_cuda();
  if (!survey.problem.empty()) {
    throw DeviceError("--device cuda: " + survey.problem);
  }
  BenchDevice device;
  device.device = Device::cuda;
  device.name = survey.name;
  device.details = cuda_line(survey);
  device.copies = "the faster of the runtime's copy and a kernel's";
  device.threads = default_threads();
  device.steps_at_once = 4e9;
  device.copy_bandwidth = [](std::size_t bytes, int repeats) {
    const CudaCopyRates rates = measure_cuda_copies(bytes, repeats);
    const Measurement runtime = summarise(rates.runtime), kernel = summarise(rates.kernel);
    return runtime.median > kernel.median ? runtime : kernel;
  };
  device.arithmetic = [](Precision precision, int repeats) {
    const CudaArithmeticRates rates = measure_cuda_arithmetic(precision, repeats);
    return ArithmeticRate{summarise(rates.simple), summarise(rates.divided)};
  };
  device.make = make_cuda_backend;
  device.make_ensemble = make_cuda_ensemble;
  return device;
}

}  // namespace sandsim::cli
