// How much of a cell a shape covers.
#pragma once

#include <array>

namespace sandsim {

/// A length or coordinate [m] in cells, rounded to 2^-30 of a cell. Edges that are meant to lie on a face or a centre
/// then do, whatever the rounding of "40 cm / 1 cm"; no sliver of 1e-17 m of sand appears beyond them; and symmetric
/// shapes cover their cells symmetrically to the last bit.
double in_cells(double length, double spacing);

/// Length that [from, to] covers of the cell [index, index + 1], all in cells: 0 to 1.
double covered_length(double from, double to, int index);

/// Part of a unit cell that a disc covers: exact but for rounding. The cell's centre lies at `offset` from the disc's
/// centre; all in cells. Symmetric in both axes and when they change places, to the last bit.
double covered_by_disc(std::array<double, 2> offset, double radius);

/// Mean over a unit cell of 1 - r/radius, which is 0 beyond the radius: a cone of height 1. As covered_by_disc().
double covered_by_cone(std::array<double, 2> offset, double radius);

/// The same along a line, for scenes of one row: the mean over [offset - 1/2, offset + 1/2] of 1 - |x|/radius.
double covered_by_cone(double offset, double radius);

}  // namespace sandsim
