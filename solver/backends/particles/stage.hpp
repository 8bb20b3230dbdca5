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

/// A hop is at most this part of a cell of the sand: the velocity is bilinear in between.
inline constexpr float longest_hop = 0.5f;

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
  std::size_t bytes() const { return bytes_; }

 private:
  std::size_t count() const { return static_cast<std::size_t>(grid_.count()); }
  std::size_t sand_cells() const { return static_cast<std::size_t>(sand_.nx) * static_cast<std::size_t>(sand_.ny); }
  template <class T>
  Array<T> allocate(std::size_t size) {
    bytes_ += size * sizeof(T);
    return Array<T>(*machine_, size);
  }
  template <class Kernel>
  void launch(const Kernel& kernel, std::size_t threads) {
    const std::size_t blocks = (threads + threads_a_block - 1) / threads_a_block;
    machine_->launch(kernel, {static_cast<int>(blocks), 1}, {threads_a_block, 1}, 0);
  }
  /// The longest way of the move, in cells of J; takes the present velocities for the next move.
  float find_ways(double dt);
  void settle();

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
  Array<float> sand_values_;  // velocities now and at the last move, depth and surface now
  Array<float> ways_;         // with a ring of ghost cells
  Array<float> offsets_;      // x, y, and where they move to
  Array<std::int64_t> ids_;   // now and next
  Array<std::int64_t> claims_;
  Array<float> longest_;
  Array<std::int64_t> counts_;  // born, left
  Array<float> positions_;      // allocated by the first capture
  Array<std::uint8_t> visible_;
  HostArray<float> captured_positions_;
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
  sand_values_ = allocate<float>(6 * cells);
  sand_.velocity_x = sand_values_.data(), sand_.velocity_y = sand_.velocity_x + cells;
  before_x_ = sand_.velocity_y + cells, before_y_ = before_x_ + cells;
  sand_.depth = before_y_ + cells, sand_.surface = sand_.depth + cells;
  ways_ = allocate<float>(2 * (static_cast<std::size_t>(sand_.nx) + 2) * (static_cast<std::size_t>(sand_.ny) + 2));
  offsets_ = allocate<float>(4 * count());
  ids_ = allocate<std::int64_t>(2 * count());
  claims_ = allocate<std::int64_t>(count());
  longest_ = allocate<float>(1);
  counts_ = allocate<std::int64_t>(2);

  particles_.x = {grid_.columns, grid_.refinement, sides.x_min, sides.x_max};
  particles_.y = {grid_.rows, grid_.refinement, sides.y_min, sides.y_max};
  particles_.layers = grid_.layers, particles_.seed = particles.seed;
  particles_.offset_x = offsets_.data(), particles_.offset_y = particles_.offset_x + count();
  particles_.moved_x = particles_.offset_y + count(), particles_.moved_y = particles_.moved_x + count();
  particles_.id = ids_.data(), particles_.next_id = particles_.id + count();
  particles_.claims = claims_.data();

  const std::vector<std::int64_t> none(count(), no_claim);
  machine_->upload(claims_.data(), none.data(), none.size());
  settle();
  report_ = {grid_.count(), 0, 0, 0, 0};
}

template <class Machine>
float ParticleStage<Machine>::find_ways(double dt) {
  const std::size_t ring = ways_.size() / 2;
  float longest = 0.0f;
  machine_->upload(longest_.data(), &longest, 1);
  const auto scale = static_cast<float>(0.5 * dt / spacing_);
  launch(WayKernel{sand_, before_x_, before_y_, scale, ways_.data(), ways_.data() + ring, longest_.data()}, ring);
  std::swap(sand_.velocity_x, before_x_), std::swap(sand_.velocity_y, before_y_);
  machine_->download(&longest, longest_.data(), 1);
  return longest;
}

template <class Machine>
void ParticleStage<Machine>::move(double dt) {
  const float longest = find_ways(dt);
  if (!(longest > 0.0f)) {
    return;  // everything rests, and so do they
  }
  const float hops = std::ceil(longest / (longest_hop * static_cast<float>(grid_.refinement)));
  const std::size_t ring = ways_.size() / 2;
  report_.moves += 1;
  launch(MoveKernel{particles_, sand_.nx, ways_.data(), ways_.data() + ring, static_cast<int>(std::min(hops, 1e6f)),
                    counts_.data() + 1},
         count());
  settle();
  std::int64_t counted[2];
  machine_->download(counted, counts_.data(), 2);
  report_.born = counted[0] - report_.count, report_.left = counted[1];
  report_.merged = report_.born - report_.left;
}

template <class Machine>
void ParticleStage<Machine>::settle() {
  launch(SettleKernel{particles_, report_.moves, counts_.data()}, count());
  std::swap(particles_.id, particles_.next_id);
}

template <class Machine>
void ParticleStage<Machine>::begin_capture() {
  if (positions_.size() == 0) {
    positions_ = allocate<float>(3 * count());
    visible_ = allocate<std::uint8_t>(count());
    captured_positions_ = HostArray<float>(*machine_, 3 * count());
    captured_ids_ = HostArray<std::int64_t>(*machine_, count());
    captured_visible_ = HostArray<std::uint8_t>(*machine_, count());
  }
  launch(ShowKernel{particles_, sand_, origin_x_, origin_y_, spacing_, hide_below_, positions_.data(), visible_.data()},
         count());
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
