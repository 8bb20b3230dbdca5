// Limits that all raster readers share.
#pragma once

#include <cstdint>

namespace sandsim {

/// The most values of a raster: 2 GiB as doubles. More is a broken header rather than a terrain.
inline constexpr std::uint64_t most_raster_values = std::uint64_t{1} << 28;

}  // namespace sandsim
