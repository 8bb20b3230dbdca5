// The particles of the CPU backend, compiled once for all its instances.
#pragma once

#include "solver/backends/particles/stage.hpp"
#include "solver/backends/particles/threaded_machine.hpp"

namespace sandsim::particles {

extern template class ParticleStage<ThreadedMachine>;

}  // namespace sandsim::particles
