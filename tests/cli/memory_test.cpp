// What memory there is, and what does not fit into it.
#include "cli/memory.hpp"

#include <sys/resource.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "cli/machine.hpp"
#include "solver/errors.hpp"
#include "tests/support/catch.hpp"

namespace sandsim::cli {
namespace {

/// Limits the address space of the process as `ulimit -v` does, while it lives.
class AddressSpace {
 public:
  explicit AddressSpace(rlim_t bytes) {
    getrlimit(RLIMIT_AS, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    REQUIRE(setrlimit(RLIMIT_AS, &limit) == 0);
  }
  ~AddressSpace() { setrlimit(RLIMIT_AS, &before_); }
  AddressSpace(const AddressSpace&) = delete;
  AddressSpace& operator=(const AddressSpace&) = delete;

 private:
  rlimit before_{};
};

Scene scene_of(int nx, int ny) {
  Scene scene;
  scene.grid.cells = {nx, ny};
  scene.grid.spacing = 0.5;
  scene.sand.friction_angle = 0.5;
  scene.time.end = scene.time.frame_interval = 1.0;
  return scene;
}

TEST_CASE("the limit of the address space counts as memory that is there") {
  const double without = available_memory();
  const AddressSpace limit(rlim_t{2} << 30);
  CHECK(available_memory() <= 2147483648.0);
  CHECK(available_memory() < without);
}

TEST_CASE("what would fit does, over the same area") {
  const AddressSpace limit(rlim_t{2} << 30);
  const double available = available_memory();
  std::string message;
  try {
    require_memory(scene_of(40000, 20000));
  } catch (const DeviceError& error) {
    message = error.what();
  }
  // 32 bytes a cell and three frames of three fields, 68 in all: so many cells, twice as many along x as along y.
  const int least = static_cast<int>(0.85 * std::sqrt(available / 68.0 / 2.0));  // two digits, rounded down
  int nx = 0, ny = 0;
  double spacing = 0.0;
  const std::size_t fit = message.find("about ", message.find("What would fit"));
  REQUIRE(fit != std::string::npos);
  REQUIRE(std::sscanf(message.c_str() + fit, "about %d x %d cells, with a spacing of %lf m", &nx, &ny, &spacing) == 3);
  CHECK(ny > least);
  CHECK_THAT(spacing * nx, Catch::Matchers::WithinRel(20000.0, 0.005));  // three digits
  CHECK_NOTHROW(require_memory(scene_of(nx, ny)));
}

TEST_CASE("on CUDA the state takes no memory of the host") {
  const AddressSpace limit(rlim_t{2} << 30);
  const Needs needs = needs_of(scene_of(1, 1));
  const int row = static_cast<int>(available_memory() / (needs.memory_bytes() - 0.5 * needs.state_bytes));
  CHECK_THROWS_AS(require_memory(scene_of(row, 1), Device::cpu), DeviceError);
  CHECK_NOTHROW(require_memory(scene_of(row, 1), Device::cuda));
}

}  // namespace
}  // namespace sandsim::cli
