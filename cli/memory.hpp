// Whether a scene fits into this machine's memory.
#pragma once

#include "solver/device.hpp"
#include "solver/needs.hpp"
#include "solver/scene.hpp"

namespace sandsim::cli {

/// Throws DeviceError if a run of the scene needs more memory than is available here, with what it needs and what would
/// fit. The system hands out memory that it does not have and later kills whoever uses it: better to say so beforehand.
/// The state of a run on CUDA lies on the device, which looks after itself.
void require_memory(const Scene& scene, Device device = Device::cpu);

}  // namespace sandsim::cli
