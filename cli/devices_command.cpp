#include <fmt/format.h>

#include <ostream>

#include "cli/commands.hpp"
#include "cli/machine.hpp"
#include "cli/text.hpp"

namespace sandsim::cli {

ExitCode devices_command(Console& console) {
  const int threads = default_threads();
  console.out << fmt::format("cpu   {}, {} thread{}, compiled for {}, {} of memory available\n", processor_name(),
                             threads, threads == 1 ? "" : "s", vector_instructions(), format_bytes(available_memory()))
              << "cuda  " << cuda_line(survey_cuda()) << '\n';
  return ExitCode::done;
}

}  // namespace sandsim::cli
