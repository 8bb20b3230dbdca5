#include "io/raster/write_npy.hpp"

#include <fmt/format.h>

#include <bit>

namespace sandsim {

namespace {

std::string npy_header(const char* type, const std::string& shape) {
  static_assert(std::endian::native == std::endian::little);  // which the types say
  constexpr std::size_t start = 10, alignment = 64;           // of the header's text; of the data
  std::string header = fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}), }}", type, shape);
  header.append(alignment - (start + header.size() + 1) % alignment, ' ');
  header += '\n';
  std::string bytes("\x93NUMPY\x01\x00", 8);
  bytes += static_cast<char>(header.size() & 0xFF);
  bytes += static_cast<char>(header.size() >> 8);
  return bytes + header;
}

}  // namespace

std::string npy_bytes(std::span<const double> values, std::size_t nx, std::size_t ny) {
  std::string bytes = npy_header("<f8", fmt::format("{}, {}", ny, nx));
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
  return bytes;
}

std::string npy_bytes(std::span<const float> values, const std::array<int, 3>& points) {
  std::string bytes = npy_header("<f4", fmt::format("{}, {}, {}", points[2], points[1], points[0]));
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
  return bytes;
}

}  // namespace sandsim
