// Where an object meets the sand of one column.
#pragma once

#include "solver/objects/object.hpp"

namespace sandsim::coupling {

/// The part of a column of sand that an object overlaps.
struct Contact {
  double overlap = 0.0;    // [m]
  double lowest = 0.0;     // [m] height of the object's lowest point in the column; +endless if it is not there
  double highest = 0.0;    // [m] of its highest
  objects::Vec3 velocity;  // [m/s] mean over the overlap, 0 without
};

/// The column stands at (x, y), its sand from `bed` to `surface` [m]. What of the object is below the bed does not
/// count. Velocities are linear in z, so that an interval's mean is the velocity of its middle: the integral over
/// Omega_s in eq. 20 is exact where the intervals are.
SANDSIM_HD Contact find_contact(const objects::ShapeView& shape, const objects::RigidState& state, double x, double y,
                                double bed, double surface, double sample_spacing) {
  const objects::Intervals inside =
      objects::inside_column(shape, state.pose, x, y, {bed, objects::endless}, sample_spacing);
  Contact contact;
  contact.lowest = inside.count > 0 ? inside.items[0].from : objects::endless;
  contact.highest = inside.count > 0 ? inside.items[inside.count - 1].to : -objects::endless;
  for (int k = 0; k < inside.count; ++k) {
    const double from = inside.items[k].from, to = physics::minimum(inside.items[k].to, surface);
    if (to > from) {
      contact.overlap += to - from;
      contact.velocity = contact.velocity + (to - from) * state.velocity_at({x, y, 0.5 * (from + to)});
    }
  }
  if (contact.overlap > 0.0) {
    contact.velocity = (1.0 / contact.overlap) * contact.velocity;
  }
  return contact;
}

}  // namespace sandsim::coupling
