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
              << "cuda  " << (has_cuda_backend() ? "built in" : "not built in: this sandsim has no CUDA backend")
              << '\n';
  return ExitCode::done;
}

}  // namespace sandsim::cli
