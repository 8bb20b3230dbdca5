// Sums over many values in an order that every machine can follow: value k goes to lane k mod 32, each lane adds its
// values in order, and the lanes are added in halves. The same bits for any number of threads, on any device.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "solver/physics/math.hpp"

namespace sandsim {

inline constexpr int sum_lanes = 32;

/// Sums over cells: of h, of (hu^2 + hv^2)/(2 h), of cells that move, and the largest speeds and depth.
struct CellSums {
  double depth = 0.0;      // [m]
  double energy = 0.0;     // [m^3/s^2]
  double max_speed = 0.0;  // [m/s]
  std::int64_t moving_cells = 0;
  double max_depth = 0.0;        // [m]
  double max_speed_above = 0.0;  // [m/s] of sand deeper than a threshold

  /// `buried` of the cell's sand lies under an object; `above` is the threshold. [m]
  template <class R>
  SANDSIM_HD void add_cell(R h_cell, R hu_cell, R hv_cell, double buried, R above) {
    const double h = static_cast<double>(h_cell);
    const double hu = static_cast<double>(hu_cell), hv = static_cast<double>(hv_cell);
    depth += h + buried;
    max_depth = physics::maximum(max_depth, h + buried);
    if (hu != 0.0 || hv != 0.0) {
      const double square = hu * hu + hv * hv;
      moving_cells += 1;
      energy += square / (2.0 * h);
      const double speed = physics::square_root(square) / h;
      max_speed = physics::maximum(max_speed, speed);
      max_speed_above = physics::maximum(max_speed_above, h_cell > above ? speed : 0.0);
    }
  }
  SANDSIM_HD CellSums& operator+=(const CellSums& other) {
    depth += other.depth, energy += other.energy, moving_cells += other.moving_cells;
    max_speed = physics::maximum(max_speed, other.max_speed);
    max_depth = physics::maximum(max_depth, other.max_depth);
    max_speed_above = physics::maximum(max_speed_above, other.max_speed_above);
    return *this;
  }
};

/// The sum over k = 0 .. n - 1 on the host: add(lane, k) adds the value k to a lane.
template <class T, class Add>
T sum_in_lanes(std::size_t n, Add add) {
  std::array<T, sum_lanes> lanes{};
  for (std::size_t k = 0; k < n; ++k) {
    add(lanes[k % sum_lanes], k);
  }
  for (std::size_t half = sum_lanes / 2; half > 0; half /= 2) {
    for (std::size_t lane = 0; lane < half; ++lane) {
      lanes[lane] += lanes[lane + half];
    }
  }
  return lanes[0];
}

}  // namespace sandsim
