// How far the sand of a run went, in the numbers that hazard maps and experiments use.
#pragma once

#include <cmath>
#include <limits>

namespace sandsim {

/// A way down, seen from its end.
struct Descent {
  double distance = std::numeric_limits<double>::quiet_NaN();  // [m] horizontal
  double drop = std::numeric_limits<double>::quiet_NaN();      // [m] of elevation, H

  /// atan(H/L), NaN where nothing has moved. [rad]
  double travel_angle() const {
    return distance > 0.0 ? std::atan(drop / distance) : std::numeric_limits<double>::quiet_NaN();
  }
};

/// Sand counts where it is deeper than a threshold. Numbers that do not exist are NaN.
struct RunoutReport {
  double above = 0.0;  // [m] the threshold
  /// From the top of the release (the mean position of those of its cells whose surface is at most the threshold below
  /// the highest; sources belong to it) to the farthest new ground that bears sand at the end (see add_ground()), or 0.
  Descent front;
  /// Of the centre of mass. Not known with sources, nor when more than 1 % of the sand has left the grid.
  Descent center_of_mass;
  double area = 0.0;       // [m^2] of all cells that held sand in some frame, with output.maxima in some step
  double max_depth = 0.0;  // [m] likewise
  double max_speed = 0.0;  // [m/s] likewise
  double deposit_front = std::numeric_limits<double>::quiet_NaN();  // [m] largest x of the sand at the end
  double deposit_height = 0.0;                                      // [m] largest depth at the end
};

}  // namespace sandsim
