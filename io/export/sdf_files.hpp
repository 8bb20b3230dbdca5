// Sampled signed distances as files that read_sdf() reads back.
#pragma once

#include <filesystem>

#include "solver/objects/distance_grid.hpp"

namespace sandsim {

/// Writes the data set `distance` (z, y, x) in metres with the attributes origin_x, origin_y, origin_z and spacing.
/// The file is whole or not there. Throws OutputError.
void write_hdf5_sdf(const std::filesystem::path& path, const objects::DistanceGrid& grid);

}  // namespace sandsim
