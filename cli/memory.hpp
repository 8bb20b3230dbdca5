// Whether a scene fits into this machine's memory.
#pragma once

#include "solver/scene.hpp"

namespace sandsim::cli {

/// Throws DeviceError if not even the least that a run of the scene needs is available. The system hands out memory
/// that it does not have and later kills whoever uses it: better to say so beforehand.
void require_memory(const Scene& scene);

}  // namespace sandsim::cli
