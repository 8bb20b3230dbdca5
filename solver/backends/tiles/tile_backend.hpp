// A backend that keeps the state on a machine (a device, or the host for tests) and steps it tile by tile. A loop of
// steps runs on the machine from frame to frame; the host sets the control before and reads it after.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "solver/backend.hpp"
#include "solver/backends/coupling/prepare.hpp"
#include "solver/backends/diagnostics.hpp"
#include "solver/backends/expected_bytes.hpp"
#include "solver/backends/halo.hpp"
#include "solver/backends/particles/stage.hpp"
#include "solver/backends/tiles/couple_kernel.hpp"
#include "solver/backends/tiles/ensemble_kernel.hpp"
#include "solver/backends/tiles/kernels.hpp"
#include "solver/errors.hpp"
#include "solver/stage_timer.hpp"

namespace sandsim::tiles {

/// Machine: HostMachine or CudaMachine. Tile: BalancedTile or PaperTile; `tile` comes with the scheme's switches.
template <class Machine, class Tile>
class TileBackend final : public Backend {
  using R = typename Tile::Real;
  template <class T>
  using Array = typename Machine::template Array<T>;
  template <class T>
  using HostArray = typename Machine::template HostArray<T>;

 public:
  TileBackend(const std::shared_ptr<Machine>& machine, const BackendConfig& config, const InitialState& initial,
              const Tile& tile);

  std::string device() const override { return machine_->name(); }
  int threads() const override { return 1; }
  std::int64_t memory_bytes() const override {
    return static_cast<std::int64_t>(bytes_ + (particles_ ? particles_->bytes() : 0));
  }
  double bytes_per_step() const override;

  void set_state(const StateArrays& state) override;
  StateArrays state() const override;

  double stable_step() const override { return static_cast<double>(tile_.stable_step(control_.fastest)); }
  SpeedLimit speed_limit() const override;
  double slope_violation() const override {
    return inspect([](const auto& d) { return largest_slope_violation(d); });
  }

  void advance(StepLoop& loop, const StepRules& rules, std::int64_t most, const LoopStages& stages,
               const std::function<void()>& meanwhile) override;
  void move_particles(double dt) override;
  ParticleArrays particles() const override { return particles_->arrays(); }
  void set_particles(const ParticleArrays& particles) override { particles_->set(particles); }
  ParticleReport particle_report() const override { return particles_->report(); }
  void begin_capture(const CaptureRequest& request) override;
  Capture end_capture() override;
  StepOutcome step(double dt) override;
  double rain(const SandRain& rain, double dt) override;
  ObjectEffect couple(const ObjectStep& one, const std::vector<ObjectStep>& all) override;

  GridStatistics statistics() const override;
  FieldValues field(const std::string& name) const override;
  std::vector<ProbeSample> sample(const std::vector<std::int64_t>& cells) const override;
  void update_maxima(double time) override;
  FinalFields maxima() const override;
  void set_maxima(const FinalFields& fields) override;
  Incident find_broken() const override {
    return inspect([](const auto& d) { return first_broken(d); });
  }

  /// For launches of many backends together, whose controls are elsewhere on the machine.
  MemberView<Tile> view(Control<R>* control) const {
    return {tile_, control, rains_.data(), static_cast<int>(config_.rains.size()), maxima_};
  }
  Control<R> control_for(const StepLoop& loop, const StepRules& rules, std::int64_t most) const;
  void take_control(const Control<R>& control) { control_ = control; }

 private:
  int nx() const { return config_.grid.cells[0]; }
  int ny() const { return config_.grid.cells[1]; }
  std::size_t cells() const { return config_.grid.cell_count(); }
  GridShape cell_blocks() const {
    constexpr std::size_t most = 4096;  // a thread takes further cells
    return {static_cast<int>(std::clamp<std::size_t>((cells() + cell_threads - 1) / cell_threads, 1, most)), 1};
  }

  void lay_out_tiles();
  void check_memory(const InitialState& initial) const;
  template <class T>
  Array<T> allocate(std::size_t count);
  void take_material(const InitialState& initial);
  FieldView<R> upload_map(const Field<R>& host, Array<R>& copy);
  void lay_out_states();
  void take_rains();
  void take_objects();
  void take_others(coupling::Job<R>& job, const ObjectStep& one, const std::vector<ObjectStep>& all);
  void launch_step(bool rain_follows);
  void launch_maxima();
  void put_control() { machine_->upload(control_array_.data(), &control_, 1); }
  void get_control() { machine_->download(&control_, control_array_.data(), 1); }
  void launch_sums() const;
  void launch_field(const std::string& name, R* values) const;
  R find_fastest() const;
  void put_bed(const std::vector<R>& values);
  /// ask(Diagnosed) of a copy of the state on the host: for the rare questions.
  template <class Ask>
  auto inspect(const Ask& ask) const;

  std::shared_ptr<Machine> machine_;
  typename Machine::Loop loop_;
  BackendConfig config_;
  Halo halo_;
  Tile tile_;
  TileLayout layout_;
  BlockShape shape_;
  GridShape grid_;
  std::size_t bytes_ = 0;
  Field<R> bed_, mu_, alpha_, cap_;  // as the host has them; the bed without objects
  Array<R> bed_copy_, mu_copy_, alpha_copy_, cap_copy_;
  Array<R> ground_copy_;  // the bed without objects; only with covering objects
  Array<double> buried_;  // likewise
  Array<R> states_;       // h, hu, hv of either state
  Array<double> side_mass_;
  Array<std::int64_t> rain_cells_;
  Array<RainView> rains_;
  MaximaView<R> maxima_;
  /// An object's shape on the machine.
  struct ShapeCopy {
    Array<objects::Primitive> primitives;
    Array<objects::Instruction> instructions;
    Array<float> grid;
    objects::ShapeView view;
  };
  std::vector<ShapeCopy> shapes_;
  Array<double> coupling_scratch_;
  Array<int> coupling_levels_;
  Array<coupling::CouplingSums> coupling_sums_;
  Array<coupling::Body> other_bodies_;
  Array<R> maxima_array_;
  Control<R> control_;  // the host's copy; the machine's between put and get
  Array<Control<R>> control_array_;
  Array<CellSums> row_sums_;  // and behind them the total
  Array<R> found_speed_;
  Array<std::int64_t> found_cell_;
  std::unique_ptr<particles::ParticleStage<Machine>> particles_;  // null without config.particles
  // Of the capture under way:
  CaptureRequest request_;
  Array<R> staging_;  // the captured fields, one behind the other
  HostArray<R> captured_;
  HostArray<CellSums> captured_sums_;
  Array<std::int64_t> probe_cells_;
  Array<double> probe_values_;
  HostArray<double> captured_probes_;
};

}  // namespace sandsim::tiles

#include "solver/backends/tiles/tile_backend_objects.hpp"
#include "solver/backends/tiles/tile_backend_state.hpp"
#include "solver/backends/tiles/tile_backend_steps.hpp"
