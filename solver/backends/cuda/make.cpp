#include <memory>

#include "solver/backends/cuda/cuda.hpp"

namespace sandsim {
namespace cuda {
class CudaMachine;
std::shared_ptr<CudaMachine> make_machine();
}  // namespace cuda
namespace tiles {
using SharedCuda = std::shared_ptr<cuda::CudaMachine>;
template <class R, int Order, class Machine>
std::unique_ptr<Backend> make_balanced(const Machine& machine, const BackendConfig& config,
                                       const InitialState& initial);
template <class R, class Machine>
std::unique_ptr<Backend> make_paper(const Machine& machine, const BackendConfig& config, const InitialState& initial);

namespace {
template <class R>
std::unique_ptr<Backend> make(const SharedCuda& machine, const BackendConfig& config, const InitialState& initial) {
  if (config.numerics.scheme == Scheme::paper) {
    return make_paper<R>(machine, config, initial);
  }
  return config.numerics.order == 2 ? make_balanced<R, 2>(machine, config, initial)
                                    : make_balanced<R, 1>(machine, config, initial);
}
}  // namespace
}  // namespace tiles

std::unique_ptr<Backend> make_cuda_backend(const BackendConfig& config, const InitialState& initial) {
  const auto machine = cuda::make_machine();
  return config.numerics.precision == Precision::float32 ? tiles::make<float>(machine, config, initial)
                                                         : tiles::make<double>(machine, config, initial);
}

}  // namespace sandsim
