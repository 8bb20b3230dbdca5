#include "solver/backends/cuda/instances.cuh"

template std::unique_ptr<sandsim::Backend> sandsim::tiles::make_balanced<float, 1>(const SharedCuda&,
                                                                                   const BackendConfig&,
                                                                                   const InitialState&);
