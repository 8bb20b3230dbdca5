// The tile backends and ensembles of a machine. Machine: a shared pointer to one, which may serve many backends.
#pragma once

#include <memory>

#include "solver/backends/choose_instance.hpp"
#include "solver/backends/tiles/balanced_tile.hpp"
#include "solver/backends/tiles/paper_tile.hpp"
#include "solver/backends/tiles/tile_backend.hpp"
#include "solver/backends/tiles/tile_ensemble.hpp"

namespace sandsim::tiles {

/// A tile of the paper's scheme with the switches of a run; its other numbers are filled in by the backend.
template <class Tile>
Tile paper_tile(const BackendConfig& config) {
  using R = typename Tile::Real;
  Tile tile;
  tile.switches = {config.numerics.momentum_flux == MomentumFlux::full ? R(1) : R(0.5), config.numerics.rest_gate};
  tile.desingularised = config.numerics.velocity == VelocityForm::desingularised;
  return tile;
}

/// Balanced scheme of the given order in precision R.
template <class R, int Order, class Machine>
std::unique_ptr<Backend> make_balanced(const Machine& machine, const BackendConfig& config,
                                       const InitialState& initial) {
  return choose_instance(variant_of(config, initial),
                         [&](auto flat, auto uniform, auto one_d) -> std::unique_ptr<Backend> {
                           using Tile = BalancedTile<R, Order, flat.value, uniform.value, one_d.value>;
                           using Made = TileBackend<typename Machine::element_type, Tile>;
                           return std::make_unique<Made>(machine, config, initial, Tile{});
                         });
}

/// The paper's scheme in precision R.
template <class R, class Machine>
std::unique_ptr<Backend> make_paper(const Machine& machine, const BackendConfig& config, const InitialState& initial) {
  return choose_instance(variant_of(config, initial),
                         [&](auto flat, auto uniform, auto one_d) -> std::unique_ptr<Backend> {
                           using Tile = PaperTile<R, flat.value, uniform.value, one_d.value>;
                           using Made = TileBackend<typename Machine::element_type, Tile>;
                           return std::make_unique<Made>(machine, config, initial, paper_tile<Tile>(config));
                         });
}

template <class R, int Order, class Machine>
std::unique_ptr<Ensemble> make_balanced_ensemble(const Machine& machine, const std::vector<EnsembleMember>& members) {
  return choose_instance(variant_of(members), [&](auto flat, auto uniform, auto one_d) -> std::unique_ptr<Ensemble> {
    using Tile = BalancedTile<R, Order, flat.value, uniform.value, one_d.value>;
    using Made = TileEnsemble<typename Machine::element_type, Tile>;
    return std::make_unique<Made>(machine, members, [](const BackendConfig&) { return Tile{}; });
  });
}

template <class R, class Machine>
std::unique_ptr<Ensemble> make_paper_ensemble(const Machine& machine, const std::vector<EnsembleMember>& members) {
  return choose_instance(variant_of(members), [&](auto flat, auto uniform, auto one_d) -> std::unique_ptr<Ensemble> {
    using Tile = PaperTile<R, flat.value, uniform.value, one_d.value>;
    using Made = TileEnsemble<typename Machine::element_type, Tile>;
    return std::make_unique<Made>(machine, members, &paper_tile<Tile>);
  });
}

}  // namespace sandsim::tiles
