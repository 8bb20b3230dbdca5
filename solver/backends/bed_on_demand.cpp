#include "solver/backends/bed_on_demand.hpp"

#include <utility>

namespace sandsim {
namespace {

class BedOnDemand final : public Backend {
 public:
  BedOnDemand(const BackendConfig& config, MakeBackend make) : config_(config), make_(std::move(make)) {
    config_.covers = false;
    backend_ = make_(config_);
  }

  std::string device() const override { return backend_->device(); }
  int threads() const override { return backend_->threads(); }
  std::int64_t memory_bytes() const override { return backend_->memory_bytes(); }
  double bytes_per_step() const override { return backend_->bytes_per_step(); }

  void set_state(const StateArrays& state) override {
    if (state.has_covers() && !config_.covers) {
      make_bed();
    }
    backend_->set_state(state);
  }
  StateArrays state() const override { return backend_->state(); }
  double stable_step() const override { return backend_->stable_step(); }
  SpeedLimit speed_limit() const override { return backend_->speed_limit(); }
  double slope_violation() const override { return backend_->slope_violation(); }

  void advance(StepLoop& loop, const StepRules& rules, std::int64_t most, const LoopStages& stages,
               const std::function<void()>& meanwhile) override {
    meanwhile();
    advance_step_by_step(*this, config_, loop, rules, most, stages);
  }
  void move_particles(double dt) override { backend_->move_particles(dt); }
  ParticleArrays particles() const override { return backend_->particles(); }
  void set_particles(const ParticleArrays& particles) override { backend_->set_particles(particles); }
  ParticleReport particle_report() const override { return backend_->particle_report(); }
  void begin_capture(const CaptureRequest& request) override { backend_->begin_capture(request); }
  Capture end_capture() override { return backend_->end_capture(); }
  StepOutcome step(double dt) override { return backend_->step(dt); }
  double rain(const SandRain& rain, double dt) override { return backend_->rain(rain, dt); }

  /// Without a bed, a covering object does nothing but say whether it reaches the sand.
  ObjectEffect couple(const ObjectStep& one, const std::vector<ObjectStep>& all) override {
    const ObjectEffect effect = backend_->couple(one, all);
    if (config_.covers || config_.objects[one.object]->coupling() == Coupling::drag || !effect.changed) {
      return effect;
    }
    const StateArrays state = backend_->state();
    const FinalFields maxima = config_.maxima ? backend_->maxima() : FinalFields{};
    const ParticleArrays particles = config_.particles ? backend_->particles() : ParticleArrays{};
    make_bed();
    backend_->set_state(state);
    if (config_.particles) {
      backend_->set_particles(particles);
    }
    if (config_.maxima) {
      backend_->set_maxima(maxima);
    }
    return backend_->couple(one, all);
  }

  GridStatistics statistics() const override { return backend_->statistics(); }
  FieldValues field(const std::string& name) const override { return backend_->field(name); }
  std::vector<ProbeSample> sample(const std::vector<std::int64_t>& cells) const override {
    return backend_->sample(cells);
  }
  void update_maxima(double time) override { backend_->update_maxima(time); }
  FinalFields maxima() const override { return backend_->maxima(); }
  void set_maxima(const FinalFields& fields) override { backend_->set_maxima(fields); }
  Incident find_broken() const override { return backend_->find_broken(); }

 private:
  void make_bed() {
    config_.covers = true;
    backend_.reset();  // its memory first
    backend_ = make_(config_);
  }

  BackendConfig config_;
  MakeBackend make_;
  std::unique_ptr<Backend> backend_;
};

}  // namespace

std::unique_ptr<Backend> make_bed_on_demand(const BackendConfig& config, const MakeBackend& make) {
  return std::make_unique<BedOnDemand>(config, make);
}

}  // namespace sandsim
