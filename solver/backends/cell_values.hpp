// What is asked of one cell between steps, the same on every machine.
#pragma once

#include <cmath>

#include "solver/backends/cover.hpp"
#include "solver/physics/velocity.hpp"

namespace sandsim {

/// The fields of series.h5 that a state gives, and the depth and the bed as the flow has them.
enum class CellField : int {
  depth,
  momentum_x,
  momentum_y,
  velocity_x,
  velocity_y,
  surface,
  bed,
  flowing_depth,
  flow_bed
};

/// Cell (i, j), of whose sand h flows above `bed`.
template <class R>
SANDSIM_HD R cell_value(CellField field, const Cover<R>& cover, int i, int j, R h, R hu, R hv, R bed, R dry_depth) {
  switch (field) {
    case CellField::depth:
      return cover.depth(i, j, h);
    case CellField::momentum_x:
      return hu;
    case CellField::momentum_y:
      return hv;
    case CellField::velocity_x:
      return physics::quotient_velocity(hu, h, dry_depth);
    case CellField::velocity_y:
      return physics::quotient_velocity(hv, h, dry_depth);
    case CellField::surface:
      return static_cast<R>(cover.surface(i, j, h, bed));
    case CellField::bed:
      return cover.terrain(i, j, bed);
    case CellField::flowing_depth:
      return h;
    case CellField::flow_bed:
      break;
  }
  return bed;
}

/// Takes a cell's state at `time` into its largest depth and speed and its time of arrival (NaN: not yet). Of its depth
/// of sand, h flows. Arrival and speed count above a depth only, and speed as long as the cell has not drained to a
/// share of its largest depth (see drained_share in runout.hpp).
template <class R>
SANDSIM_HD void take_maxima(R depth, R h, R hu, R hv, R time, R above, R drained, R dry_depth, R& max_depth,
                            R& max_speed, R& arrival) {
  const R speed = physics::quotient_velocity(physics::length(hu, hv), h, dry_depth);
  max_depth = physics::maximum(max_depth, depth);
  max_speed = physics::maximum(max_speed, physics::select(h > above && depth > drained * max_depth, speed, R(0)));
  arrival = arrival != arrival && depth > above ? time : arrival;
}

}  // namespace sandsim
