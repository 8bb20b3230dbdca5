// The instances of the CUDA backend, each in a source file of its own.
#pragma once

#include <memory>

#include "solver/backends/cuda/cuda_machine.cuh"
#include "solver/backends/tiles/instances.hpp"

namespace sandsim::particles {

extern template class ParticleStage<cuda::CudaMachine>;

}  // namespace sandsim::particles

namespace sandsim::tiles {

using SharedCuda = std::shared_ptr<cuda::CudaMachine>;

}  // namespace sandsim::tiles
