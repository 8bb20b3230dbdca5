// Packs of cells: as many neighbours in a row as the processor works on at once.
#pragma once

#include <cstddef>
#include <experimental/simd>

#include "solver/physics/parameters.hpp"

namespace sandsim::cpu {

template <class R>
using Pack = std::experimental::native_simd<R>;

/// The pack of cells i, i + 1, ... of a row.
template <class R>
SANDSIM_HD Pack<R> load(const R* row, std::ptrdiff_t i) {
  return Pack<R>(row + i, std::experimental::element_aligned);
}
template <class R>
SANDSIM_HD void store(R* row, std::ptrdiff_t i, const Pack<R>& values) {
  values.copy_to(row + i, std::experimental::element_aligned);
}

/// Lanes below `count`: the ones that are still inside at the end of a row.
template <class R>
SANDSIM_HD typename Pack<R>::mask_type first_lanes(std::ptrdiff_t count) {
  return Pack<R>([](auto lane) { return static_cast<R>(static_cast<int>(lane)); }) < Pack<R>(static_cast<R>(count));
}

/// The step's numbers in every lane.
template <class R>
physics::StepParameters<Pack<R>> broadcast(const physics::StepParameters<R>& p) {
  return {p.dx, p.g, p.dt, p.dry_depth, p.inverse_dx, p.ratio, p.cell_a_step, p.inverse_g_dt};
}
template <class R>
physics::Material<Pack<R>> broadcast(const physics::Material<R>& m) {
  return {m.mu, m.alpha, m.cap};
}

}  // namespace sandsim::cpu
