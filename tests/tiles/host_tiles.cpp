#include "tests/tiles/host_tiles.hpp"

#include "solver/backends/tiles/check_ensemble.hpp"
#include "solver/backends/tiles/host_machine.hpp"
#include "solver/backends/tiles/instances.hpp"

namespace sandsim::test {
namespace {

template <class R>
std::unique_ptr<Backend> make(const BackendConfig& config, const InitialState& initial) {
  const auto machine = std::make_shared<tiles::HostMachine>();
  if (config.numerics.scheme == Scheme::paper) {
    return tiles::make_paper<R>(machine, config, initial);
  }
  return config.numerics.order == 2 ? tiles::make_balanced<R, 2>(machine, config, initial)
                                    : tiles::make_balanced<R, 1>(machine, config, initial);
}

template <class R>
std::unique_ptr<Ensemble> make(const std::vector<EnsembleMember>& members) {
  const auto machine = std::make_shared<tiles::HostMachine>();
  const Numerics& numerics = members.front().config.numerics;
  if (numerics.scheme == Scheme::paper) {
    return tiles::make_paper_ensemble<R>(machine, members);
  }
  return numerics.order == 2 ? tiles::make_balanced_ensemble<R, 2>(machine, members)
                             : tiles::make_balanced_ensemble<R, 1>(machine, members);
}

}  // namespace

std::unique_ptr<Backend> make_host_tiles(const BackendConfig& config, const InitialState& initial) {
  return config.numerics.precision == Precision::float32 ? make<float>(config, initial) : make<double>(config, initial);
}

std::unique_ptr<Ensemble> make_host_ensemble(const std::vector<EnsembleMember>& members) {
  tiles::check_ensemble(members);
  return members.front().config.numerics.precision == Precision::float32 ? make<float>(members) : make<double>(members);
}

}  // namespace sandsim::test
