// Without a device the program says so and exits with 77, which ctest reports as skipped.
#define CATCH_CONFIG_RUNNER
#include <cstdio>

#include "solver/backends/cuda/cuda.hpp"
#include "tests/support/catch.hpp"

int main(int argc, char** argv) {
  const std::string problem = sandsim::survey_cuda().problem;
  if (!problem.empty()) {
    std::printf("skipped: %s\n", problem.c_str());
    return 77;
  }
  return Catch::Session().run(argc, argv);
}
