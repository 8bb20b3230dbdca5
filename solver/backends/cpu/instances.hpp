// The instances of the CPU backend, each in a source file of its own.
#pragma once

#include <memory>

#include "solver/backend.hpp"
#include "solver/backends/choose_instance.hpp"
#include "solver/backends/cpu/balanced_rows.hpp"
#include "solver/backends/cpu/cpu_backend.hpp"
#include "solver/backends/cpu/paper_rows.hpp"

namespace sandsim::cpu {

/// Balanced scheme of the given order in precision R.
template <class R, int Order>
std::unique_ptr<Backend> make_balanced(const BackendConfig& config, const InitialState& initial);

/// The paper's scheme in precision R.
template <class R>
std::unique_ptr<Backend> make_paper(const BackendConfig& config, const InitialState& initial);

template <class R, int Order>
std::unique_ptr<Backend> make_balanced(const BackendConfig& config, const InitialState& initial) {
  return choose_instance(variant_of(config, initial),
                         [&](auto flat, auto uniform, auto one_d) -> std::unique_ptr<Backend> {
                           using Rows = BalancedRows<R, Order, flat.value, uniform.value, one_d.value>;
                           const auto make = [](const StepFields<R>& fields, const physics::StepParameters<R>& p) {
                             return Rows(fields, p);
                           };
                           return std::make_unique<CpuBackend<Rows, decltype(make)>>(config, initial, make);
                         });
}

template <class R>
std::unique_ptr<Backend> make_paper(const BackendConfig& config, const InitialState& initial) {
  const R factor = config.numerics.momentum_flux == MomentumFlux::full ? R(1) : R(0.5);
  const bool gate = config.numerics.rest_gate;
  const bool desingularised = config.numerics.velocity == VelocityForm::desingularised;
  const R courant = static_cast<R>(config.courant);
  return choose_instance(variant_of(config, initial),
                         [&](auto flat, auto uniform, auto one_d) -> std::unique_ptr<Backend> {
                           using Rows = PaperRows<R, flat.value, uniform.value, one_d.value>;
                           const auto make = [=](const StepFields<R>& fields, const physics::StepParameters<R>& p) {
                             const physics::PaperSwitches<Pack<R>> switches{factor, physics::Mask<Pack<R>>(gate)};
                             return Rows(fields, p, switches, desingularised, courant);
                           };
                           return std::make_unique<CpuBackend<Rows, decltype(make)>>(config, initial, make);
                         });
}

}  // namespace sandsim::cpu
