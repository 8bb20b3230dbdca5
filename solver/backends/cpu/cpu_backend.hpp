// The CPU backend: memory, threads and tiles around the row kernels of a scheme. The same bits for any number of
// threads and any tile size: cells depend on the old state only, and reductions are maxima or sums in a fixed order.
#pragma once

#include <omp.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "solver/backend.hpp"
#include "solver/backends/coupling/host_scratch.hpp"
#include "solver/backends/coupling/prepare.hpp"
#include "solver/backends/cpu/rows.hpp"
#include "solver/backends/cpu/team.hpp"
#include "solver/backends/diagnostics.hpp"
#include "solver/backends/halo.hpp"
#include "solver/backends/particles/threaded.hpp"

namespace sandsim::cpu {

template <class Rows>
using R_of = typename Rows::Real;

/// Rows: BalancedRows or PaperRows. Make: builds one from fields and step parameters.
template <class Rows, class Make>
class CpuBackend final : public Backend {
  using R = typename Rows::Real;

 public:
  CpuBackend(const BackendConfig& config, const InitialState& initial, Make make);

  std::string device() const override { return "cpu"; }
  int threads() const override { return team_.usual(); }
  std::int64_t memory_bytes() const override;
  double bytes_per_step() const override;

  void set_state(const StateArrays& state) override;
  StateArrays state() const override;
  double stable_step() const override;
  SpeedLimit speed_limit() const override;
  double slope_violation() const override { return largest_slope_violation(diagnosed()); }

  void advance(StepLoop& loop, const StepRules& rules, std::int64_t most, const LoopStages& stages,
               const std::function<void()>& meanwhile) override {
    meanwhile();
    advance_step_by_step(*this, config_, loop, rules, most, stages);
  }
  void move_particles(double dt) override;
  ParticleArrays particles() const override { return particles_->arrays(); }
  void set_particles(const ParticleArrays& particles) override { particles_->set(particles); }
  ParticleReport particle_report() const override { return particles_->report(); }
  void begin_capture(const CaptureRequest& request) override;
  Capture end_capture() override { return std::move(capture_); }
  StepOutcome step(double dt) override;
  double rain(const SandRain& rain, double dt) override;
  ObjectEffect couple(const ObjectStep& one, const std::vector<ObjectStep>& all) override;

  GridStatistics statistics() const override { return grid_statistics(diagnosed(), config_.above, team_.size()); }
  FieldValues field(const std::string& name) const override { return named_field(diagnosed(), name); }
  std::vector<ProbeSample> sample(const std::vector<std::int64_t>& cells) const override;
  void update_maxima(double time) override { maxima_.update(diagnosed(), time, team_.size()); }
  FinalFields maxima() const override { return maxima_.fields(); }
  void set_maxima(const FinalFields& fields) override { maxima_.set(fields); }
  Incident find_broken() const override { return first_broken(diagnosed()); }

 private:
  int nx() const { return config_.grid.cells[0]; }
  int ny() const { return config_.grid.cells[1]; }
  std::size_t next() const { return 1 - current_; }
  /// Rows of a block whose speed needs rows of another block.
  static constexpr bool speed_needs_neighbours = Rows::speed_needs_neighbours && !Rows::one_d;

  void take_material(const InitialState& initial);
  StepFields<R> fields() const;
  physics::StepParameters<R> parameters(R dt) const;
  Diagnosed<R> diagnosed() const;
  /// The bounding speeds of rows [j0, j1) of the state in buffer `which`.
  void take_speeds(const Rows& rows, std::size_t which, int j0, int j1);
  /// A single row has no neighbours across.
  void fill_ghost_rows(std::size_t which) {
    if constexpr (!Rows::one_d) {
      halo_.fill_rows(h_[which].view(), hu_[which].view(), hv_[which].view());
    }
  }
  /// Rows of a block in the next step: every thread has some.
  int block_rows() const {
    const int each = (ny() + team_.size() - 1) / team_.size();
    return config_.block_rows > 0 ? config_.block_rows : std::min(64, each);
  }
  int blocks() const { return (ny() + block_rows() - 1) / block_rows(); }
  // Each takes a step into the other buffers and returns its flags.
  int step_alone(const Rows& rows);
  int step_together(const Rows& rows);
  /// Steps a block of rows and takes the speeds of those whose neighbours it holds.
  int step_block(const Rows& rows, Scratch<R>& scratch, int block);
  /// The speeds of a block's first and last row, once all blocks are done.
  void step_edges(const Rows& rows, int block);
  double outflow(double dt) const;
  /// After a change to rows [j0, j1) of the present state: their ghost cells, and the speeds around them.
  void refresh_rows(int j0, int j1);

  BackendConfig config_;
  Make make_;
  Halo halo_;
  Team team_;
  int tile_ = 0;
  std::size_t current_ = 0;
  std::array<Field<R>, 2> h_, hu_, hv_;
  Field<R> bed_, mu_, alpha_, cap_;
  Field<R> ground_;       // the bed without objects; only with covering objects
  Field<double> buried_;  // likewise
  physics::Material<R> material_{};
  std::vector<R> row_speed_;                      // [m/s] of each row of the present state; the largest bounds the step
  std::vector<Scratch<R>> scratch_;               // one a thread
  std::array<std::vector<double>, 4> side_mass_;  // x_min, x_max, y_min, y_max; empty where the side is closed
  SideFlow flow_;
  Maxima<R> maxima_;
  Capture capture_;
  coupling::HostScratch coupling_scratch_;
  int particle_threads_ = 1;                                                         // at most; also on small grids
  std::shared_ptr<particles::ThreadedMachine> particle_machine_;                     // null without config.particles
  std::unique_ptr<particles::ParticleStage<particles::ThreadedMachine>> particles_;  // likewise
};

/// As many threads as were asked for; else up to one a processor where the grid gives them enough to do.
inline Team team_for(const BackendConfig& config) {
  constexpr std::size_t small = 16384;  // cells below which a second thread costs more than it brings
  if (config.threads > 0) {
    return {std::min(config.threads, config.grid.cells[1]), false};
  }
  return {config.grid.cell_count() < small ? 1 : std::min(omp_get_max_threads(), config.grid.cells[1]), true};
}

template <class Rows, class Make>
CpuBackend<Rows, Make>::CpuBackend(const BackendConfig& config, const InitialState& initial, Make make)
    : config_(config),
      make_(std::move(make)),
      halo_{config.grid.cells[0], config.grid.cells[1], config.boundaries},
      team_(team_for(config)) {
  tile_ = std::min(nx(), config.tile_columns > 0 ? config.tile_columns : 256);

  for (std::size_t k = 0; k < 2; ++k) {
    h_[k] = Field<R>(nx(), ny(), R(0));
    hu_[k] = Field<R>(nx(), ny(), R(0));
    hv_[k] = Field<R>(nx(), ny(), R(0));
  }
  row_speed_.assign(static_cast<std::size_t>(ny()), R(0));
  take_material(initial);
  scratch_.assign(static_cast<std::size_t>(team_.most()), Scratch<R>(Rows::scratch_rows, tile_));

  flow_.nx = nx(), flow_.ny = ny();
  const auto open = [&](std::size_t side, BoundaryKind kind, int faces) -> double* {
    if (kind != BoundaryKind::open) {
      return nullptr;
    }
    side_mass_[side].assign(static_cast<std::size_t>(faces), 0.0);
    return side_mass_[side].data();
  };
  flow_.x_min = open(0, config.boundaries.x_min, ny()), flow_.x_max = open(1, config.boundaries.x_max, ny());
  if (!Rows::one_d) {
    flow_.y_min = open(2, config.boundaries.y_min, nx()), flow_.y_max = open(3, config.boundaries.y_max, nx());
  }
  if (config.maxima) {
    maxima_ = Maxima<R>(config.grid.cell_count(), static_cast<R>(config.above), static_cast<R>(config.drained));
  }

  if (config.particles) {
    particle_threads_ = config.threads > 0 ? config.threads : omp_get_max_threads();
    particle_machine_ = std::make_shared<particles::ThreadedMachine>(particle_threads_);
    particles_ = std::make_unique<particles::ParticleStage<particles::ThreadedMachine>>(
        particle_machine_, *config.particles, config.grid, config.boundaries);
  }

  const std::vector<R> depth(initial.depth.begin(), initial.depth.end()), still(depth.size(), R(0));
  set_state({depth, still, still});
}

template <class Rows, class Make>
void CpuBackend<Rows, Make>::take_material(const InitialState& initial) {
  if constexpr (!Rows::flat) {
    bed_ = stored_bed<R>(initial.bed, halo_, config_.covers);
    if (config_.covers) {
      ground_ = stored_bed<R>(initial.bed, halo_, true);
      buried_ = Field<double>(nx(), ny(), 0.0);
    }
  }
  if constexpr (Rows::uniform) {
    material_ = {static_cast<R>(initial.friction_coefficient.front()), static_cast<R>(initial.hbar_scale.front()),
                 static_cast<R>(initial.hbar_cap.front())};
  } else {
    mu_ = stored_map<R>(initial.friction_coefficient, halo_);
    alpha_ = stored_map<R>(initial.hbar_scale, halo_);
    cap_ = stored_map<R>(initial.hbar_cap, halo_);
  }
}

template <class Rows, class Make>
std::int64_t CpuBackend<Rows, Make>::memory_bytes() const {
  std::size_t bytes = maxima_.bytes() + (particles_ ? particles_->bytes() : 0);
  for (const auto* pair : {&h_, &hu_, &hv_}) {
    bytes += (*pair)[0].bytes() + (*pair)[1].bytes();
  }
  for (const Field<R>* field : {&bed_, &mu_, &alpha_, &cap_, &ground_}) {
    bytes += field->bytes();
  }
  bytes += buried_.bytes();
  for (const Scratch<R>& scratch : scratch_) {
    bytes += scratch.bytes();
  }
  return static_cast<std::int64_t>(bytes);
}

template <class Rows, class Make>
double CpuBackend<Rows, Make>::bytes_per_step() const {
  // The state in and out, and every map that is stored in full (a repeated row stays in cache). That is 24 bytes a
  // cell in float32 on flat terrain; write-allocation of the three outputs is not counted.
  int words = 6;
  for (const Field<R>* field : {&bed_, &mu_, &alpha_, &cap_}) {
    words += field->view().stride > 0 ? 1 : 0;
  }
  return static_cast<double>(config_.grid.cell_count()) * words * static_cast<double>(sizeof(R));
}

template <class Rows, class Make>
StepFields<R_of<Rows>> CpuBackend<Rows, Make>::fields() const {
  const std::size_t to = next();
  return {
      h_[current_].view(), hu_[current_].view(), hv_[current_].view(), h_[to].view(), hu_[to].view(), hv_[to].view(),
      bed_.view(),         mu_.view(),           alpha_.view(),        cap_.view(),   material_};
}

template <class Rows, class Make>
physics::StepParameters<R_of<Rows>> CpuBackend<Rows, Make>::parameters(R dt) const {
  const R dx = static_cast<R>(config_.grid.spacing);
  return physics::step_parameters(dx, static_cast<R>(config_.gravity), dt,
                                  static_cast<R>(physics::dry_depth_fraction) * dx);
}

template <class Rows, class Make>
Diagnosed<R_of<Rows>> CpuBackend<Rows, Make>::diagnosed() const {
  return {nx(),
          ny(),
          config_.grid.spacing,
          parameters(R(0)),
          h_[current_].view(),
          hu_[current_].view(),
          hv_[current_].view(),
          bed_.view(),
          mu_.view(),
          material_,
          {ground_.view(), buried_.view()},
          Rows::flat,
          Rows::uniform};
}

template <class Rows, class Make>
void CpuBackend<Rows, Make>::set_state(const StateArrays& state) {
  const auto load = [&]<class T>(const FieldValues& values, Field<T>& to) {
    const auto& from = std::get<std::vector<T>>(values);
    for (int j = 0; j < ny(); ++j) {
      std::copy_n(from.begin() + static_cast<std::ptrdiff_t>(j) * nx(), nx(), to.row(j));
    }
  };
  load(state.depth, h_[current_]);
  load(state.momentum_x, hu_[current_]);
  load(state.momentum_y, hv_[current_]);
  if (state.has_covers()) {
    load(state.bed, bed_);
    halo_.fill_covered_bed(bed_.view(), ground_.view());
    load(state.buried, buried_);
  }
  for (int j = 0; j < ny(); ++j) {
    halo_.fill_columns(h_[current_].view(), hu_[current_].view(), hv_[current_].view(), j);
  }
  fill_ghost_rows(current_);
  take_speeds(make_(fields(), parameters(R(0))), current_, 0, ny());
}

template <class Rows, class Make>
StateArrays CpuBackend<Rows, Make>::state() const {
  return state_of(diagnosed());
}

}  // namespace sandsim::cpu

#include "solver/backends/cpu/cpu_backend_steps.hpp"
