// Fields into NumPy arrays.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace sandsim {

/// The bytes of a .npy file (format 1.0) of ny * nx float64 values, x fastest. read_npy() gives the same bits back.
std::string npy_bytes(std::span<const double> values, std::size_t nx, std::size_t ny);

}  // namespace sandsim
