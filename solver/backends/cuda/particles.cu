#include "solver/backends/cuda/instances.cuh"

namespace sandsim::particles {

template class ParticleStage<cuda::CudaMachine>;

}  // namespace sandsim::particles
