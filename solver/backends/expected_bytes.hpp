// What a backend will need, before it allocates anything.
#pragma once

#include <string>

#include "solver/backend.hpp"

namespace sandsim {

/// Bytes that the state, its maps and the particles will take, halos left out.
double expected_bytes(const BackendConfig& config, const InitialState& initial);

/// Throws DeviceError, with what could be made smaller, if `needed` bytes are more than the `present` ones of `place`.
void require_bytes(const BackendConfig& config, double needed, double present, const std::string& place);

}  // namespace sandsim
