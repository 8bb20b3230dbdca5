// Differences of the surface s = h + b between cells, and the slope that friction has to hold.
#pragma once

#include "solver/physics/parameters.hpp"

namespace sandsim::physics {

/// s_right - s_left, computed from differences, and 0 below the level of rounding (so that a lake is flat).
template <class R>
SANDSIM_HD R surface_difference(R h_left, R h_right, R b_left, R b_right) {
  const R difference = (h_right - h_left) + (b_right - b_left);
  const R noise = R(2 * unit_rounding<R>) * (h_left + h_right);
  return select(absolute(difference) <= noise, R(0), difference);
}

/// |s_right - s_left| as far as sand can push over the face: at the edge of a drop (the lower surface at or below the
/// upper bed) only the upper cell's own depth counts. This is what friction has to hold.
template <class R>
SANDSIM_HD R surface_drop(R difference, R h_left, R h_right, R b_left, R b_right) {
  const R drop = absolute(difference), bed_jump = b_right - b_left;
  const R from_right = minimum(drop, 2 * h_right), from_left = minimum(drop, 2 * h_left);
  return select(bed_jump >= h_left, from_right, select(-bed_jump >= h_right, from_left, drop));
}

/// Depth and bed of a cell and its two neighbours along one axis.
template <class R>
struct Line {
  R h_minus, h, h_plus;
  R b_minus, b, b_plus;
};

/// Differences of s and h towards the minus and the plus neighbour.
template <class R>
struct Differences {
  R s_minus, s_plus, h_minus, h_plus;
};

/// A neighbour whose bed stands above this cell's surface cannot push: its differences are limited by the opposite
/// ones (a wall or a shore gives 0, a film on a slope is unchanged). Flat: the bed is not looked at.
template <bool Flat, class R>
SANDSIM_HD Differences<R> differences(const Line<R>& line) {
  const R s_minus = surface_difference(line.h_minus, line.h, line.b_minus, line.b);
  const R s_plus = surface_difference(line.h, line.h_plus, line.b, line.b_plus);
  const R h_minus = line.h - line.h_minus, h_plus = line.h_plus - line.h;
  if constexpr (Flat) {
    return {s_minus, s_plus, h_minus, h_plus};
  } else {
    const auto blocked_minus = (line.b_minus - line.b >= line.h) & (s_minus < R(0));
    const auto blocked_plus = (line.b_plus - line.b >= line.h) & (s_plus > R(0));
    const R s_limited = minmod(s_minus, s_plus), h_limited = minmod(h_minus, h_plus);
    return {select(blocked_minus, s_limited, s_minus), select(blocked_plus, s_limited, s_plus),
            select(blocked_minus, h_limited, h_minus), select(blocked_plus, h_limited, h_plus)};
  }
}

/// Compact slope of the surface along one axis. [-]
template <class R>
SANDSIM_HD R compact_slope(const Differences<R>& d, R inverse_dx) {
  return R(0.5f) * (d.s_minus + d.s_plus) * inverse_dx;
}

}  // namespace sandsim::physics
