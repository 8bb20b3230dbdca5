// Backends on tiles that run on the host: the code of a device's kernels, block by block.
#pragma once

#include <memory>

#include "solver/backend.hpp"
#include "solver/ensemble.hpp"

namespace sandsim::test {

std::unique_ptr<Backend> make_host_tiles(const BackendConfig& config, const InitialState& initial);
std::unique_ptr<Ensemble> make_host_ensemble(const std::vector<EnsembleMember>& members);

}  // namespace sandsim::test
