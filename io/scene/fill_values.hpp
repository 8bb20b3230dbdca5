// Values of a raster that stand for "no data" in many programs, but are not declared as such in the file.
#pragma once

#include <cstddef>
#include <optional>

#include "io/scene/problems.hpp"
#include "solver/raster.hpp"

namespace sandsim {

struct FillValue {
  double value = 0.0;
  std::size_t count = 0;
  std::size_t column = 0;  // of the first one
  std::size_t row = 0;     // likewise, from the south
};

/// The first value that is used for NODATA (-9999, -99999, -32767, -32768, or beyond 1e30, where the largest numbers of
/// a type lie) and is further from all other values than these are from each other.
std::optional<FillValue> find_fill_value(const Raster& raster);

/// What is said of it: that it is there, where, and how to declare it.
Complaint describe_fill_value(const FillValue& fill);

}  // namespace sandsim
