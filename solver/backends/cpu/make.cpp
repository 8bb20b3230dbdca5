#include <new>

#include "solver/backend.hpp"
#include "solver/errors.hpp"

namespace sandsim {
namespace cpu {
template <class R, int Order>
std::unique_ptr<Backend> make_balanced(const BackendConfig& config, const InitialState& initial);
template <class R>
std::unique_ptr<Backend> make_paper(const BackendConfig& config, const InitialState& initial);

namespace {
template <class R>
std::unique_ptr<Backend> make(const BackendConfig& config, const InitialState& initial) {
  if (config.numerics.scheme == Scheme::paper) {
    return make_paper<R>(config, initial);
  }
  return config.numerics.order == 2 ? make_balanced<R, 2>(config, initial) : make_balanced<R, 1>(config, initial);
}
}  // namespace
}  // namespace cpu

std::unique_ptr<Backend> make_cpu_backend(const BackendConfig& config, const InitialState& initial) {
  try {
    return config.numerics.precision == Precision::float32 ? cpu::make<float>(config, initial)
                                                           : cpu::make<double>(config, initial);
  } catch (const std::bad_alloc&) {
    throw DeviceError("the state of " + std::to_string(config.grid.cells[0]) + " x " +
                      std::to_string(config.grid.cells[1]) + " cells does not fit into memory");
  }
}

}  // namespace sandsim
