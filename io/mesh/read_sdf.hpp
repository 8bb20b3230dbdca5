// Sampled signed distances from files: NumPy arrays, HDF5 and SDFGen's text.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "solver/objects/distance_grid.hpp"

namespace sandsim {

/// Reads a signed distance, negative inside; the extension tells the format: .npy, .h5 or .sdf. Lengths are as the file
/// has them. Throws InputError: "file: problem", of text "file:line:col: problem". There are two samples along each
/// axis at least, all of them finite.
objects::DistanceGrid read_sdf(const std::filesystem::path& path);

/// The data set `distance` of an HDF5 file, with the dimensions z, y, x. Its attributes origin_x, origin_y, origin_z
/// and spacing tell where it lies; without all four the result's spacing is 0.
objects::DistanceGrid read_hdf5_sdf(const std::filesystem::path& path);

// From memory; `name` stands for the file.

/// A .npy array with the dimensions z, y, x. The file knows neither origin nor spacing: the result's spacing is 0.
objects::DistanceGrid read_npy_sdf(std::string_view bytes, const std::string& name);
/// SDFGen's text: numbers of samples along x, y, z; origin; spacing; the samples, x fastest.
objects::DistanceGrid read_sdfgen(std::string_view text, const std::string& name);

}  // namespace sandsim
