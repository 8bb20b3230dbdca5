// Backends on tiles that run on the host: the code of a device's kernels, block by block.
#pragma once

#include <memory>

#include "solver/backend.hpp"

namespace sandsim::test {

std::unique_ptr<Backend> make_host_tiles(const BackendConfig& config, const InitialState& initial);

}  // namespace sandsim::test
