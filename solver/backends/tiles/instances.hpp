// The tile backends of a machine.
#pragma once

#include <memory>

#include "solver/backends/choose_instance.hpp"
#include "solver/backends/tiles/balanced_tile.hpp"
#include "solver/backends/tiles/paper_tile.hpp"
#include "solver/backends/tiles/tile_backend.hpp"

namespace sandsim::tiles {

/// Machine: a shared pointer to one, which may serve many backends. Balanced scheme of the given order in precision R.
template <class R, int Order, class Machine>
std::unique_ptr<Backend> make_balanced(const Machine& machine, const BackendConfig& config,
                                       const InitialState& initial) {
  return choose_instance(config, initial, [&](auto flat, auto uniform, auto one_d) -> std::unique_ptr<Backend> {
    using Tile = BalancedTile<R, Order, flat.value, uniform.value, one_d.value>;
    return std::make_unique<TileBackend<typename Machine::element_type, Tile>>(machine, config, initial, Tile{});
  });
}

/// The paper's scheme in precision R.
template <class R, class Machine>
std::unique_ptr<Backend> make_paper(const Machine& machine, const BackendConfig& config, const InitialState& initial) {
  return choose_instance(config, initial, [&](auto flat, auto uniform, auto one_d) -> std::unique_ptr<Backend> {
    using Tile = PaperTile<R, flat.value, uniform.value, one_d.value>;
    Tile tile;
    tile.switches = {config.numerics.momentum_flux == MomentumFlux::full ? R(1) : R(0.5), config.numerics.rest_gate};
    tile.desingularised = config.numerics.velocity == VelocityForm::desingularised;
    return std::make_unique<TileBackend<typename Machine::element_type, Tile>>(machine, config, initial, tile);
  });
}

}  // namespace sandsim::tiles
