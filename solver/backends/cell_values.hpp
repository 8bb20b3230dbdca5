// What is asked of one cell between steps, the same on every machine.
#pragma once

#include <cmath>

#include "solver/physics/velocity.hpp"

namespace sandsim {

/// The fields of series.h5 that a state gives.
enum class CellField : int { depth, momentum_x, momentum_y, velocity_x, velocity_y, surface, bed };

template <class R>
SANDSIM_HD R cell_value(CellField field, R h, R hu, R hv, R b, R dry_depth) {
  switch (field) {
    case CellField::depth:
      return h;
    case CellField::momentum_x:
      return hu;
    case CellField::momentum_y:
      return hv;
    case CellField::velocity_x:
      return physics::quotient_velocity(hu, h, dry_depth);
    case CellField::velocity_y:
      return physics::quotient_velocity(hv, h, dry_depth);
    case CellField::surface:
      return h + b;
    case CellField::bed:
      break;
  }
  return b;
}

/// Takes a cell's state at `time` into its largest depth and speed and its time of arrival (NaN: not yet).
template <class R>
SANDSIM_HD void take_maxima(R h, R hu, R hv, R time, R arrival_depth, R dry_depth, R& max_depth, R& max_speed,
                            R& arrival) {
  const R speed = physics::quotient_velocity(physics::length(hu, hv), h, dry_depth);
  max_depth = physics::maximum(max_depth, h);
  max_speed = physics::maximum(max_speed, speed);
  arrival = arrival != arrival && h > arrival_depth ? time : arrival;
}

}  // namespace sandsim
