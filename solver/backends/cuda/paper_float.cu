#include "solver/backends/cuda/instances.cuh"

template std::unique_ptr<sandsim::Backend> sandsim::tiles::make_paper<float>(const SharedCuda&, const BackendConfig&,
                                                                             const InitialState&);
