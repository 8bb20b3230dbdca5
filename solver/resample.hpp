// Values of a raster at other points than its own, and on the cells of the grid.
#pragma once

#include <vector>

#include "solver/raster.hpp"
#include "solver/scene.hpp"

namespace sandsim {

/// Bilinear interpolation at (x, y) [m]. A point has a value where the raster's cell that it lies in has one:
/// neighbours beyond the edge, or without data (NaN), are left out and the weights of the others add up to 1. Elsewhere
/// the result is NaN. On the edge between cells one with data is enough. A point on a column or row of centres, to 1e-9
/// of the spacing or the rounding of the coordinates, takes that column's or row's values alone: on a centre the result
/// has the bits of the value. Mirrored and transposed rasters give the same bits at mirrored and transposed points.
double sample(const Raster& raster, double x, double y);

/// Whether the functions below can be used: a raster without georeference must have the grid's shape. Stretching
/// another shape over the grid in silence would hide a file that belongs to another scene.
bool fits(const Raster& raster, const Grid& grid);

/// The raster's values on the grid (ny * nx, x fastest): as they are if it has no georeference. Along an axis where its
/// spacing is less than the grid's, the mean over the cell by covered area; else bilinear at the centre as sample().
/// NaN where a mean has data for less than half of the cell. The raster fits the grid.
std::vector<double> resample(const Raster& raster, const Grid& grid);

/// A raster of depths on the cells.
struct SpreadRaster {
  std::vector<double> depth;  // [m] ny * nx, x fastest
  double outside = 0.0;       // [m^3] beyond the grid
};

/// Spreads the volume in the raster's cells over those that they overlap with; NaN is a depth of 0. On the grid's own
/// cells the values keep their bits. In a 1-D scene the depth is the mean over that part of the row's width that the
/// raster covers. Mirrored and transposed rasters give the same bits. The raster fits the grid.
SpreadRaster spread(const Raster& raster, const Grid& grid);

/// The value of the raster's cell with data whose centre is nearest to (x, y); of those equally near the southernmost,
/// and of these the westernmost. Coordinates are rounded to 2^-30 of the spacing.
class NearestValue {
 public:
  /// The raster is georeferenced, has data somewhere, and outlives this.
  explicit NearestValue(const Raster& raster);
  double at(double x, double y) const;

 private:
  const Raster& raster_;
  std::vector<int> below_;  // the nearest row with data in the column, this one or southwards; -1: none
  std::vector<int> above_;  // likewise northwards; ny: none
};

}  // namespace sandsim
