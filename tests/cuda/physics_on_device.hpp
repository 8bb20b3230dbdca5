#pragma once

namespace sandsim::test {

/// Steps many made-up cells on the device and on the host; how many have different bits, in either precision.
int count_cells_that_differ();

}  // namespace sandsim::test
