#include "io/raster/write_npy.hpp"

#include <fmt/format.h>

#include <bit>

namespace sandsim {

std::string npy_bytes(std::span<const double> values, std::size_t nx, std::size_t ny) {
  static_assert(std::endian::native == std::endian::little);  // which '<f8' says
  constexpr std::size_t start = 10, alignment = 64;           // of the header's text; of the data
  std::string header = fmt::format("{{'descr': '<f8', 'fortran_order': False, 'shape': ({}, {}), }}", ny, nx);
  header.append(alignment - (start + header.size() + 1) % alignment, ' ');
  header += '\n';
  std::string bytes("\x93NUMPY\x01\x00", 8);
  bytes += static_cast<char>(header.size() & 0xFF);
  bytes += static_cast<char>(header.size() >> 8);
  bytes += header;
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
  return bytes;
}

}  // namespace sandsim
