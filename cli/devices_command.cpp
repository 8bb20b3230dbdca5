#include <fmt/format.h>

#include <ostream>

#include "cli/commands.hpp"
#include "cli/machine.hpp"
#include "cli/text.hpp"
#include "solver/backends/cuda/cuda.hpp"

namespace sandsim::cli {

namespace {

std::string cuda_version(int number) {
  return fmt::format("{}.{}", number / 1000, number % 1000 / 10);
}

std::string cuda_line(const CudaSurvey& survey) {
  if (!survey.problem.empty()) {
    return survey.problem;
  }
  return fmt::format("{}, compute capability {}.{}, {} multiprocessors, {} of {} of memory free, driver {}, runtime {}",
                     survey.name, survey.capability / 10, survey.capability % 10, survey.processors,
                     format_bytes(static_cast<double>(survey.free)), format_bytes(static_cast<double>(survey.total)),
                     cuda_version(survey.driver), cuda_version(survey.runtime));
}

}  // namespace

ExitCode devices_command(Console& console) {
  const int threads = default_threads();
  console.out << fmt::format("cpu   {}, {} thread{}, compiled for {}, {} of memory available\n", processor_name(),
                             threads, threads == 1 ? "" : "s", vector_instructions(), format_bytes(available_memory()))
              << "cuda  " << cuda_line(survey_cuda()) << '\n';
  return ExitCode::done;
}

}  // namespace sandsim::cli
