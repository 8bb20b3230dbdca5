// Checks that a backend gives the bits of the CPU backend: the same cases for tiles on the host and on a device.
#pragma once

#include <functional>
#include <memory>

#include "solver/backend.hpp"
#include "solver/ensemble.hpp"

namespace sandsim::test {

using MakeBackend = std::function<std::unique_ptr<Backend>(const BackendConfig&, const InitialState&)>;

using MakeEnsemble = std::function<std::unique_ptr<Ensemble>(const std::vector<EnsembleMember>&)>;

/// Single steps: state, outcome, speeds, sums, over grids, boundaries, terrains, schemes and precisions.
void check_steps(const MakeBackend& make);
/// Loops of steps with sources and maxima, and the capture of a frame.
void check_loops(const MakeBackend& make);
/// The bound of the next step is that of the state alone, also after sand that slows it: on the CPU and the backend.
void check_bounds(const MakeBackend& make);
/// Objects that displace and drag.
void check_objects_on(const MakeBackend& make);
/// Particles that follow the sand.
void check_particles_on(const MakeBackend& make);
/// Runs side by side, of different grids, materials, boundaries and steps.
void check_ensemble(const MakeEnsemble& make);

}  // namespace sandsim::test
