// The sand as the particles see it, and how a backend fills it in.
#pragma once

#include "solver/backends/cell_values.hpp"
#include "solver/backends/particles/laws.hpp"

namespace sandsim::particles {

/// nx * ny values each, x fastest.
struct SandView {
  int nx = 0, ny = 0;
  Boundaries sides;
  ParticleVelocity kind = ParticleVelocity::averaged;
  float max_factor = 1.0f;                             // [-] bound on h/hbar
  float *velocity_x = nullptr, *velocity_y = nullptr;  // [m/s] that carries particles
  float* depth = nullptr;                              // [m]
  double* surface = nullptr;                           // [m]

  /// Cell (i, j), of whose sand h flows above `bed`.
  template <class R>
  SANDSIM_HD void take(int i, int j, R h, R hu, R hv, R bed, const Cover<R>& cover,
                       const physics::Material<R>& material, R dry_depth) const {
    const std::int64_t cell = static_cast<std::int64_t>(j) * nx + i;
    const R most = static_cast<R>(max_factor);
    velocity_x[cell] = carrying_velocity(hu, h, material, dry_depth, kind, most);
    velocity_y[cell] = carrying_velocity(hv, h, material, dry_depth, kind, most);
    depth[cell] = static_cast<float>(cover.depth(i, j, h));
    surface[cell] = cover.surface(i, j, h, bed);
  }
};

}  // namespace sandsim::particles
