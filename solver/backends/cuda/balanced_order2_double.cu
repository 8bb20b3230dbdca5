#include "solver/backends/cuda/instances.cuh"

namespace sandsim::tiles {

template std::unique_ptr<Backend> make_balanced<double, 2>(const SharedCuda&, const BackendConfig&,
                                                           const InitialState&);
template std::unique_ptr<Ensemble> make_balanced_ensemble<double, 2>(const SharedCuda&,
                                                                     const std::vector<EnsembleMember>&);

}  // namespace sandsim::tiles
