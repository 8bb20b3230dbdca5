// Which device a run takes, and why.
#pragma once

#include <string>

#include "solver/scene.hpp"

namespace sandsim {

enum class Device { automatic, cpu, cuda };

struct DeviceChoice {
  Device device = Device::cpu;  // cpu or cuda
  std::string name;             // "cpu", or "cuda (NVIDIA ...)"
  std::string reason;           // "asked for", or why it was taken by itself
};

/// Takes the CUDA device where one can be used and the grid is worth it, unless `wanted` says which. Throws
/// DeviceError if CUDA is wanted and cannot be used, with what is missing.
DeviceChoice choose_device(Device wanted, const Grid& grid);

}  // namespace sandsim
