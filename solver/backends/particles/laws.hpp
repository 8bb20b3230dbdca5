// How particles are born, move and are shown (section 6 of the paper), one of them at a time.
//
// A particle lies in a cell of the grid J and knows how far from its corner, in cells: small motions are not lost in a
// large coordinate. All is float, whatever the precision of the sand, so that every machine has the same particles;
// only where they are shown, in the coordinates and heights of the scene, is it double.
#pragma once

#include <cmath>
#include <cstdint>

#include "solver/backends/ghost.hpp"
#include "solver/backends/particles/philox.hpp"
#include "solver/physics/hbar.hpp"
#include "solver/physics/velocity.hpp"
#include "solver/scene.hpp"

namespace sandsim::particles {

/// A place along an axis: a cell, and the way from its corner, in [0, 1) cells. Of J, or of the sand's grid.
struct Place {
  int cell;
  float offset;
};

inline constexpr float just_below_one = 0x1.fffffep-1f;

/// One axis and its two sides.
struct Axis {
  int cells;
  BoundaryKind low, high;
};

/// From J to the sand's grid, of which one cell holds `refinement` cells of J, and back.
SANDSIM_HD Place in_sand(const Place& place, int refinement) {
  const int cell = place.cell / refinement;
  const float within = static_cast<float>(place.cell - cell * refinement) + place.offset;
  return {cell, physics::minimum(within / static_cast<float>(refinement), just_below_one)};
}
SANDSIM_HD Place in_particles(const Place& place, int refinement) {
  const float within = place.offset * static_cast<float>(refinement);
  const int part = physics::minimum(static_cast<int>(within), refinement - 1);
  return {place.cell * refinement + part, physics::minimum(within - static_cast<float>(part), just_below_one)};
}

/// Where a particle lies within its cell (eq. 30).
struct Offsets {
  float x, y, z;
};
SANDSIM_HD Offsets birth_offsets(std::int64_t id, int seed) {
  const auto bits = static_cast<std::uint64_t>(id);
  const Philox random = philox({{static_cast<std::uint32_t>(bits), static_cast<std::uint32_t>(bits >> 32), 0, 0}},
                               static_cast<std::uint32_t>(seed), 0);
  return {unit_interval(random.words[0]), unit_interval(random.words[1]), unit_interval(random.words[2])};
}

/// A particle's name: the move after which it was born (0: at the start) before the cell where. Older ones are smaller.
SANDSIM_HD std::int64_t id_of(std::int64_t move, std::int64_t cell) {
  return (move << 32) | cell;
}
/// What decides which particle stays in a cell that several enter: the oldest; of those of one age, the one that comes
/// from the cell with the smallest number. The lower half is that cell.
SANDSIM_HD std::int64_t claim_of(std::int64_t id, std::int64_t cell) {
  return ((id >> 32) << 32) | cell;
}
SANDSIM_HD std::int64_t claimant(std::int64_t claim) {
  return claim & 0xffffffff;
}

/// Velocity that carries particles in a cell, from its momentum: hu/h (eq. 31), or h/hbar times that, which is the
/// velocity of the dilute layer if the dense one stands (section 6.2). [m/s]
template <class R>
SANDSIM_HD float carrying_velocity(R momentum, R h, const physics::Material<R>& material, R dry_depth,
                                   ParticleVelocity kind, R max_factor) {
  const R mean = physics::quotient_velocity(momentum, h, dry_depth);
  if (kind == ParticleVelocity::averaged) {
    return static_cast<float>(mean);
  }
  const R hbar = physics::hbar(h, material);
  return static_cast<float>(mean * (h < max_factor * hbar ? h / hbar : max_factor));
}

/// A way along an axis, in cells and short against the grid.
SANDSIM_HD void shift(Place& place, float way) {
  const float offset = place.offset + way, whole = floorf(offset);
  place.cell += static_cast<int>(whole);
  place.offset = physics::minimum(offset - whole, just_below_one);  // a tiny step back from 0 would round to 1
}

/// Brings a place back onto the axis: to the wall, or to the other side of a periodic grid. False if it is beyond an
/// open side.
SANDSIM_HD bool bring_inside(Place& place, const Axis& axis) {
  if (place.cell >= 0 && place.cell < axis.cells) {
    return true;
  }
  const bool high = place.cell > 0;
  const BoundaryKind kind = high ? axis.high : axis.low;
  if (kind == BoundaryKind::periodic) {
    place.cell = (place.cell % axis.cells + axis.cells) % axis.cells;
  } else {
    place = high ? Place{axis.cells - 1, just_below_one} : Place{0, 0.0f};
  }
  return kind != BoundaryKind::open;
}

/// Between which centres of the sand's cells a place lies: `lower` (-1 .. n - 1) and the one above, with the weight of
/// the one above (eq. 28, 29).
struct Stencil {
  int lower;
  float weight;
};
SANDSIM_HD Stencil stencil(const Place& place) {
  const bool below = place.offset < 0.5f;
  return {below ? place.cell - 1 : place.cell, below ? place.offset + 0.5f : place.offset - 0.5f};
}

/// Bilinear interpolation (eq. 27) of the values at four centres: at the lower y, at the upper one.
template <class T>
SANDSIM_HD T interpolate(const Stencil& x, const Stencil& y, T left_below, T right_below, T left_above, T right_above) {
  const T wx = static_cast<T>(x.weight), wy = static_cast<T>(y.weight);
  const T below = (T(1) - wx) * left_below + wx * right_below;
  const T above = (T(1) - wx) * left_above + wx * right_above;
  return (T(1) - wy) * below + wy * above;
}

}  // namespace sandsim::particles
