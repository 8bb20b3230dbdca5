#include "solver/backends/particles/threaded.hpp"

namespace sandsim::particles {

template class ParticleStage<ThreadedMachine>;

}  // namespace sandsim::particles
