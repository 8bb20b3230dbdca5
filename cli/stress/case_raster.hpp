// Rasters of the stress matrix: made from a function of the cell.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "cli/stress/stress_case.hpp"

namespace sandsim::cli {

/// The values of `value` at the cells (i, j).
CaseRaster make_raster(const std::string& file, int nx, int ny, const std::function<double(int i, int j)>& value);

/// White noise in [0, height) [the values' unit], the same on every machine.
CaseRaster make_noise(const std::string& file, int nx, int ny, double height, std::uint64_t seed);

}  // namespace sandsim::cli
