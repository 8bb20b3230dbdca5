// Single values of a .npy file.
#pragma once

#include "io/raster/npy_header.hpp"

namespace sandsim {

/// One value of the header's type as a double, and whether it is one: large integers have no double.
struct NpyItem {
  double value = 0.0;
  bool exact = true;
};

/// The value whose header.item_size bytes start there.
NpyItem load_npy_item(const char* bytes, const NpyHeader& header);

}  // namespace sandsim
