// What a backend will need, before it allocates anything.
#pragma once

#include <string>

#include "solver/backend.hpp"

namespace sandsim {

/// What the state of a scene holds besides depth and momentum.
struct FieldArrays {
  bool bed = false, covers = false, maxima = false;
  int maps = 0;  // of the material
};

/// Bytes of the state and its maps, halos left out.
double field_state_bytes(const Grid& grid, Precision precision, const FieldArrays& arrays);
/// Bytes of the particles, of the sand as they see it, and of a frame of them.
double particle_state_bytes(const Grid& grid, const std::optional<Particles>& particles);

/// Bytes that the state, its maps and the particles will take, halos left out.
double expected_bytes(const BackendConfig& config, const InitialState& initial);

/// Throws DeviceError, with what could be made smaller, if `needed` bytes are more than the `present` ones of `place`.
void require_bytes(const BackendConfig& config, double needed, double present, const std::string& place);

}  // namespace sandsim
