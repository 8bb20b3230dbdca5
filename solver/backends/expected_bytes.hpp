// What a backend will need, before it allocates anything.
#pragma once

#include "solver/backend.hpp"

namespace sandsim {

/// Bytes that the state, its maps and the particles will take, halos left out.
double expected_bytes(const BackendConfig& config, const InitialState& initial);

}  // namespace sandsim
