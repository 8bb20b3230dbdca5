// The particles of a run on the machine of its backend (section 6): memory and launches. The sand does not know of
// them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "solver/backends/particles/kernels.hpp"
#include "solver/backends/tiles/block.hpp"
#include "solver/particles.hpp"
#include "solver/scene.hpp"
#include "solver/sink.hpp"

namespace sandsim::particles {

/// Machine: as for tiles::TileBackend.
template <class Machine>
class ParticleStage {
  template <class T>
  using Array = typename Machine::template Array<T>;
  template <class T>
  using HostArray = typename Machine::template HostArray<T>;

 public:
  ParticleStage(std::shared_ptr<Machine> machine, const Particles& particles, const Grid& grid,
                const Boundaries& sides);

  /// Where the backend puts the present sand before it calls move() or begin_capture().
  const SandView& sand() const { return sand_; }
  /// Moves all particles with the sand of the last `dt` seconds. Waits for the machine.
  void move(double dt);

  /// Begins to take the particles as they are drawn; end_capture() waits for them.
  void begin_capture();
  ParticleFrame end_capture();

  ParticleArrays arrays() const;
  void set(const ParticleArrays& arrays);
  const ParticleReport& report() const { return report_; }
  std::size_t bytes() const { return bytes_; }

 private:
  std::size_t count() const { return static_cast<std::size_t>(grid_.count()); }
  std::size_t sand_cells() const { return static_cast<std::size_t>(sand_.nx) * static_cast<std::size_t>(sand_.ny); }
  template <class T>
  Array<T> allocate(std::size_t size) {
    bytes_ += size * sizeof(T);
    return Array<T>(*machine_, size);
  }
  /// Blocks along the rows of `columns` threads, row by row.
  template <class Kernel>
  void launch(const Kernel& kernel, int columns, int rows) {
    machine_->launch(kernel, {rows, (columns + threads_a_block - 1) / threads_a_block}, {threads_a_block, 1}, 0);
  }
  template <class Kernel>
  void launch(const Kernel& kernel) {
    launch(kernel, kernel.box.columns(), kernel.box.rows() * grid_.layers);
  }
  ParticleBox whole() const { return {0, grid_.columns, 0, grid_.rows}; }
  MoveExtent find_ways(double dt);
  ParticleBox box_of(const MoveExtent& extent) const;

  std::shared_ptr<Machine> machine_;
  ParticleGrid grid_;
  double spacing_;              // [m] of J
  double origin_x_, origin_y_;  // [m]
  float hide_below_;            // [m]
  std::size_t bytes_ = 0;
  SandView sand_;
  float *before_x_ = nullptr, *before_y_ = nullptr;  // [m/s] velocities at the last move
  ParticleView particles_;
  ParticleReport report_;
  Array<float> sand_values_;    // velocities now and at the last move, depth now
  Array<double> surface_;       // of the sand
  Array<Way> ways_;             // with a ring of ghost cells
  Array<float> offsets_;        // x, y, and where they move to
  Array<std::int64_t> ids_;     // now, and of those that move
  Array<std::int64_t> claims_;  // by particles that enter by themselves, and that are pushed
  Array<int> entered_;
  Array<MoveExtent> extent_;
  Array<std::int64_t> counts_;  // born, left
  Array<double> positions_;     // allocated by the first capture
  Array<std::uint8_t> visible_;
  HostArray<double> captured_positions_;
  HostArray<std::int64_t> captured_ids_;
  HostArray<std::uint8_t> captured_visible_;
};

template <class Machine>
ParticleStage<Machine>::ParticleStage(std::shared_ptr<Machine> machine, const Particles& particles, const Grid& grid,
                                      const Boundaries& sides)
    : machine_(std::move(machine)),
      grid_(grid, particles),
      spacing_(grid.spacing / grid_.refinement),
      origin_x_(grid.origin[0]),
      origin_y_(grid.origin[1]),
      hide_below_(static_cast<float>(particles.hide_below.value_or(thinnest_shown * grid.spacing))) {
  sand_.nx = grid.cells[0], sand_.ny = grid.cells[1], sand_.sides = sides;
  sand_.kind = particles.velocity, sand_.max_factor = static_cast<float>(particles.max_factor);
  const std::size_t cells = sand_cells();
  sand_values_ = allocate<float>(5 * cells);
  surface_ = allocate<double>(cells);
  sand_.velocity_x = sand_values_.data(), sand_.velocity_y = sand_.velocity_x + cells;
  before_x_ = sand_.velocity_y + cells, before_y_ = before_x_ + cells;
  sand_.depth = before_y_ + cells, sand_.surface = surface_.data();
  ways_ = allocate<Way>((static_cast<std::size_t>(sand_.nx) + 2) * (static_cast<std::size_t>(sand_.ny) + 2));
  offsets_ = allocate<float>(4 * count());
  ids_ = allocate<std::int64_t>(2 * count());
  claims_ = allocate<std::int64_t>(2 * count());
  entered_ = allocate<int>(count());
  extent_ = allocate<MoveExtent>(1);
  counts_ = allocate<std::int64_t>(2);

  particles_.grid = grid_, particles_.seed = particles.seed;
  particles_.x = {sand_.nx, sides.x_min, sides.x_max}, particles_.y = {sand_.ny, sides.y_min, sides.y_max};
  particles_.offset_x = offsets_.data(), particles_.offset_y = particles_.offset_x + count();
  particles_.moved_x = particles_.offset_y + count(), particles_.moved_y = particles_.moved_x + count();
  particles_.id = ids_.data(), particles_.moved_id = particles_.id + count();
  particles_.claims = claims_.data(), particles_.pushed_claims = particles_.claims + count();
  particles_.entered = entered_.data();

  const std::vector<std::int64_t> none(claims_.size(), no_claim);
  machine_->upload(claims_.data(), none.data(), none.size());
  launch(SettleKernel{particles_, whole(), 0, counts_.data()});
  report_ = {grid_.count(), 0, 0, 0, 0};
}

/// Takes the present velocities for the next move.
template <class Machine>
MoveExtent ParticleStage<Machine>::find_ways(double dt) {
  MoveExtent extent{0.0f, sand_.nx, 1, sand_.ny, 1};
  machine_->upload(extent_.data(), &extent, 1);
  const auto scale = static_cast<float>(0.5 * dt / (spacing_ * grid_.refinement));
  launch(WayKernel{sand_, before_x_, before_y_, scale, ways_.data(), extent_.data()}, sand_.nx + 2, sand_.ny + 2);
  std::swap(sand_.velocity_x, before_x_), std::swap(sand_.velocity_y, before_y_);
  machine_->download(&extent, extent_.data(), 1);
  return extent;
}

/// The cells of J that particles may leave or enter. Of an axis that may be crossed through a periodic side, all.
template <class Machine>
ParticleBox ParticleStage<Machine>::box_of(const MoveExtent& extent) const {
  // Moving sand carries what lies within a cell of its centre; that goes as far as the longest way, and rounding.
  const auto reach = static_cast<std::int64_t>(std::min(extent.longest, 1e9f)) + 3;
  const auto range = [&](std::int64_t first, std::int64_t last, const Axis& axis, int& begin, int& end) {
    const std::int64_t low = first - reach, high = last + reach + 1;
    const bool around =
        (low < 0 && axis.low == BoundaryKind::periodic) || (high > axis.cells && axis.high == BoundaryKind::periodic);
    begin = around ? 0 : grid_.refinement * static_cast<int>(std::max<std::int64_t>(low, 0));
    end = grid_.refinement * (around ? axis.cells : static_cast<int>(std::min<std::int64_t>(high, axis.cells)));
  };
  ParticleBox box;
  range(extent.i0, -extent.i1, particles_.x, box.column0, box.column1);
  range(extent.j0, -extent.j1, particles_.y, box.row0, box.row1);
  return box;
}

template <class Machine>
void ParticleStage<Machine>::move(double dt) {
  const MoveExtent extent = find_ways(dt);
  if (!(extent.longest > 0.0f)) {
    return;  // everything rests, and so do they
  }
  const ParticleBox box = box_of(extent);
  report_.moves += 1;
  launch(MoveKernel{particles_, box, ways_.data(), counts_.data() + 1});
  launch(PushKernel{particles_, box});
  launch(SettleKernel{particles_, box, report_.moves, counts_.data()});
  std::int64_t counted[2];
  machine_->download(counted, counts_.data(), 2);
  report_.born = counted[0] - report_.count, report_.left = counted[1];
  report_.merged = report_.born - report_.left;
}

template <class Machine>
void ParticleStage<Machine>::begin_capture() {
  if (positions_.size() == 0) {
    positions_ = allocate<double>(3 * count());
    visible_ = allocate<std::uint8_t>(count());
    captured_positions_ = HostArray<double>(*machine_, 3 * count());
    captured_ids_ = HostArray<std::int64_t>(*machine_, count());
    captured_visible_ = HostArray<std::uint8_t>(*machine_, count());
  }
  launch(ShowKernel{particles_, whole(), sand_, origin_x_, origin_y_, spacing_, hide_below_, positions_.data(),
                    visible_.data()});
  machine_->begin_copy(captured_positions_.data(), positions_.data(), 3 * count());
  machine_->begin_copy(captured_ids_.data(), particles_.id, count());
  machine_->begin_copy(captured_visible_.data(), visible_.data(), count());
}

template <class Machine>
ParticleFrame ParticleStage<Machine>::end_capture() {
  machine_->finish_copies();
  const auto taken = [](const auto& from, std::size_t size) { return std::vector(from.data(), from.data() + size); };
  return {taken(captured_positions_, 3 * count()), taken(captured_ids_, count()), taken(captured_visible_, count())};
}

template <class Machine>
ParticleArrays ParticleStage<Machine>::arrays() const {
  const auto get = [this](const auto* from, std::size_t size) {
    std::vector<std::remove_cvref_t<decltype(*from)>> values(size);
    machine_->download(values.data(), from, size);
    return values;
  };
  return {get(particles_.offset_x, count()), get(particles_.offset_y, count()), get(particles_.id, count()),
          get(before_x_, sand_cells()),      get(before_y_, sand_cells()),      report_};
}

template <class Machine>
void ParticleStage<Machine>::set(const ParticleArrays& arrays) {
  const auto put = [this](auto* to, const auto& values) { machine_->upload(to, values.data(), values.size()); };
  put(particles_.offset_x, arrays.offset_x), put(particles_.offset_y, arrays.offset_y);
  put(particles_.id, arrays.id);
  put(before_x_, arrays.velocity_x), put(before_y_, arrays.velocity_y);
  report_ = arrays.report;
  const std::vector<std::int64_t> counts{report_.count + report_.born, report_.left};
  put(counts_.data(), counts);
}

}  // namespace sandsim::particles
