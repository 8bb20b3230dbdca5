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

TEST_CASE("The state alone bounds the next step, whatever the sand was before") {
  check_bounds(make_host_tiles);
}

TEST_CASE("Objects act on tiles as on the CPU and lose no sand") {
  check_objects_on(make_host_tiles);
}

TEST_CASE("Particles on tiles are those of the CPU") {
  check_particles_on(make_host_tiles);
}

TEST_CASE("Runs side by side in blocks go as each on the CPU") {
  check_ensemble(make_host_ensemble);
}

TEST_CASE("Runs that cannot go side by side are refused") {
  EnsembleMember a;
  a.config.grid.cells = {8, 8};
  EnsembleMember b = a, wide = a;
  b.config.numerics.order = 1;
  wide.config.grid.cells = {ensemble_columns + 1, 2};
  CHECK_THROWS_AS(make_host_ensemble({}), std::invalid_argument);
  CHECK_THROWS_AS(make_host_ensemble({a, b}), std::invalid_argument);
  CHECK_THROWS_AS(make_host_ensemble({wide}), std::invalid_argument);
}

}  // namespace
}  // namespace sandsim::test
