// The kernels of a device, run on the host block by block.
#include "tests/tiles/host_tiles.hpp"

#include "tests/support/catch.hpp"
#include "tests/tiles/parity.hpp"

namespace sandsim::test {
namespace {

TEST_CASE("A step on tiles gives the bits of the CPU backend") {
  check_steps(make_host_tiles);
}

TEST_CASE("A loop of steps with sources and maxima on tiles goes as on the CPU") {
  check_loops(make_host_tiles);
}

}  // namespace
}  // namespace sandsim::test
