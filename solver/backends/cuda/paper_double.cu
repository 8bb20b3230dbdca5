#include "solver/backends/cuda/instances.cuh"

namespace sandsim::tiles {

template std::unique_ptr<Backend> make_paper<double>(const SharedCuda&, const BackendConfig&, const InitialState&);
template std::unique_ptr<Ensemble> make_paper_ensemble<double>(const SharedCuda&, const std::vector<EnsembleMember>&);

}  // namespace sandsim::tiles
