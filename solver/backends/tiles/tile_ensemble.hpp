// An ensemble of tile backends on one machine.
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "solver/backends/tiles/ensemble_kernel.hpp"
#include "solver/backends/tiles/tile_backend.hpp"
#include "solver/ensemble.hpp"

namespace sandsim::tiles {

template <class Machine, class Tile>
class TileEnsemble final : public Ensemble {
  using R = typename Tile::Real;
  using Member = TileBackend<Machine, Tile>;

 public:
  /// make_tile(config): the tile with the scheme's switches.
  template <class MakeTile>
  TileEnsemble(const std::shared_ptr<Machine>& machine, const std::vector<EnsembleMember>& members,
               const MakeTile& make_tile)
      : machine_(machine),
        controls_(*machine, members.size()),
        host_controls_(*machine, members.size()),
        views_(*machine, members.size()) {
    int widest = 1, highest = 1;
    std::size_t most_cells = 0;
    std::vector<MemberView<Tile>> views;
    for (const EnsembleMember& each : members) {
      members_.push_back(std::make_unique<Member>(machine, each.config, each.initial, make_tile(each.config)));
      views.push_back(members_.back()->view(controls_.data() + views.size()));
      widest = std::max(widest, each.config.grid.cells[0]), highest = std::max(highest, each.config.grid.cells[1]);
      most_cells = std::max(most_cells, each.config.grid.cell_count());
    }
    machine_->upload(views_.data(), views.data(), views.size());
    lay_out(widest, highest, most_cells);
  }

  std::size_t size() const override { return members_.size(); }
  Backend& member(std::size_t k) override { return *members_[k]; }

  void advance(std::vector<StepLoop>& loops, const std::vector<StepRules>& rules, std::int64_t most) override {
    Control<R>* controls = host_controls_.data();
    for (std::size_t k = 0; k < size(); ++k) {
      controls[k] = members_[k]->control_for(loops[k], rules[k], most);
    }
    machine_->upload(controls_.data(), controls, size());
    machine_->launch(kernel_, {static_cast<int>(size()), 1}, shape_, shared_bytes_);
    machine_->download(controls, controls_.data(), size());
    for (std::size_t k = 0; k < size(); ++k) {
      members_[k]->take_control(controls[k]);
      loops[k] = controls[k].loop;
    }
  }

 private:
  /// One strip as wide as the widest grid, and as many strips as a block has threads for.
  void lay_out(int widest, int highest, std::size_t most_cells) {
    constexpr int warp = 32;
    shape_.width = (widest + 2 * Tile::reach + warp - 1) / warp * warp;
    shape_.strips = std::clamp(EnsembleKernel<Tile>::most_threads / shape_.width, 1, highest);
    constexpr std::size_t alignment = alignof(typename EnsembleKernel<Tile>::Resident);
    const std::size_t rows = (step_shared_bytes<Tile>(shape_) + alignment - 1) / alignment * alignment;
    const std::size_t numbers = sizeof(typename EnsembleKernel<Tile>::Resident);
    const std::size_t states = 6 * most_cells * sizeof(R);
    const bool states_fit = rows + numbers + states <= machine_->shared_bytes_a_block();
    kernel_ = {views_.data(), rows, states_fit};
    shared_bytes_ = rows + numbers + (states_fit ? states : 0);
  }

  std::shared_ptr<Machine> machine_;
  std::vector<std::unique_ptr<Member>> members_;
  typename Machine::template Array<Control<R>> controls_;
  typename Machine::template HostArray<Control<R>> host_controls_;
  typename Machine::template Array<MemberView<Tile>> views_;
  EnsembleKernel<Tile> kernel_{};
  BlockShape shape_;
  std::size_t shared_bytes_ = 0;
};

}  // namespace sandsim::tiles
