#include <memory>
#include <stdexcept>

#include "solver/backends/cuda/cuda.hpp"
#include "solver/backends/tiles/check_ensemble.hpp"

namespace sandsim {
namespace cuda {
class CudaMachine;
std::shared_ptr<CudaMachine> make_machine();
}  // namespace cuda
namespace tiles {

// Compiled in the instances: a machine's header is for the CUDA compiler only.
using SharedCuda = std::shared_ptr<cuda::CudaMachine>;
template <class R, int Order, class Machine>
std::unique_ptr<Backend> make_balanced(const Machine& machine, const BackendConfig& config,
                                       const InitialState& initial);
template <class R, class Machine>
std::unique_ptr<Backend> make_paper(const Machine& machine, const BackendConfig& config, const InitialState& initial);
template <class R, int Order, class Machine>
std::unique_ptr<Ensemble> make_balanced_ensemble(const Machine& machine, const std::vector<EnsembleMember>& members);
template <class R, class Machine>
std::unique_ptr<Ensemble> make_paper_ensemble(const Machine& machine, const std::vector<EnsembleMember>& members);

namespace {

template <class R>
std::unique_ptr<Backend> make(const SharedCuda& machine, const BackendConfig& config, const InitialState& initial) {
  if (config.numerics.scheme == Scheme::paper) {
    return make_paper<R>(machine, config, initial);
  }
  return config.numerics.order == 2 ? make_balanced<R, 2>(machine, config, initial)
                                    : make_balanced<R, 1>(machine, config, initial);
}

template <class R>
std::unique_ptr<Ensemble> make(const SharedCuda& machine, const std::vector<EnsembleMember>& members) {
  const Numerics& numerics = members.front().config.numerics;
  if (numerics.scheme == Scheme::paper) {
    return make_paper_ensemble<R>(machine, members);
  }
  return numerics.order == 2 ? make_balanced_ensemble<R, 2>(machine, members)
                             : make_balanced_ensemble<R, 1>(machine, members);
}

}  // namespace
}  // namespace tiles

std::unique_ptr<Backend> make_cuda_backend(const BackendConfig& config, const InitialState& initial) {
  const auto machine = cuda::make_machine();
  return config.numerics.precision == Precision::float32 ? tiles::make<float>(machine, config, initial)
                                                         : tiles::make<double>(machine, config, initial);
}

std::unique_ptr<Ensemble> make_cuda_ensemble(const std::vector<EnsembleMember>& members) {
  tiles::check_ensemble(members);
  const auto machine = cuda::make_machine();
  return members.front().config.numerics.precision == Precision::float32 ? tiles::make<float>(machine, members)
                                                                         : tiles::make<double>(machine, members);
}

}  // namespace sandsim
