// Values of a raster at other points than its own.
#pragma once

#include <vector>

#include "solver/raster.hpp"
#include "solver/scene.hpp"

namespace sandsim {

/// Bilinear interpolation at (x, y) [m]. The outermost half cell takes the value of the edge's centres; beyond it, and
/// where a value that is needed is NaN, the result is NaN. A value whose weight is zero is not needed.
/// A point on a column or row of centres, to 1e-9 of the spacing or the rounding of the coordinates, takes that
/// column's or row's values alone: on a centre the result has the bits of the value.
/// Mirrored and transposed rasters give the same bits at mirrored and transposed points.
double sample(const Raster& raster, double x, double y);

/// Whether resample() can be used: a raster without georeference must have the grid's shape. Stretching another shape
/// over the grid in silence would hide a file that belongs to another scene.
bool fits(const Raster& raster, const Grid& grid);

/// The raster at the grid's cell centres (ny * nx, x fastest): its values as they are if it has no georeference, else
/// sample(). The raster fits the grid.
std::vector<double> resample(const Raster& raster, const Grid& grid);

}  // namespace sandsim
