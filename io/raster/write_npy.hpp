// Fields into NumPy arrays.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>

namespace sandsim {

/// The bytes of a .npy file (format 1.0) of ny * nx float64 values, x fastest, from the south. read_npy() gives the
/// same bits back.
std::string npy_bytes(std::span<const double> values, std::size_t nx, std::size_t ny);

/// Likewise of float32 values with the dimensions z, y, x; `points` along x, y, z. read_npy_sdf() gives them back.
std::string npy_bytes(std::span<const float> values, const std::array<int, 3>& points);

}  // namespace sandsim
