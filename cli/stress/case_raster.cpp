#include "cli/stress/case_raster.hpp"

#include <fmt/format.h>

#include <bit>
#include <random>

namespace sandsim::cli {

static_assert(std::endian::native == std::endian::little, "npy_bytes() writes the machine's own doubles");

CaseRaster make_raster(const std::string& file, int nx, int ny, const std::function<double(int i, int j)>& value) {
  CaseRaster raster{file, nx, ny, {}};
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) {
      raster.values.push_back(value(i, j));
    }
  }
  return raster;
}

CaseRaster make_noise(const std::string& file, int nx, int ny, double height, std::uint64_t seed) {
  std::mt19937_64 random(seed);  // its numbers are fixed by the standard; those of the distributions are not
  return make_raster(file, nx, ny, [&](int, int) { return height * static_cast<double>(random() >> 11) * 0x1p-53; });
}

std::string npy_bytes(const CaseRaster& raster) {
  std::string header =
      fmt::format("{{'descr': '<f8', 'fortran_order': False, 'shape': ({}, {}), }}", raster.ny, raster.nx);
  constexpr std::size_t preamble = 10, block = 64;  // the values start at a multiple of 64 bytes
  header.append(block - (preamble + header.size() + 1) % block, ' ');
  header += '\n';
  std::string bytes("\x93NUMPY\x01\x00", 8);
  bytes += static_cast<char>(header.size() % 256);
  bytes += static_cast<char>(header.size() / 256);
  bytes += header;
  bytes.append(reinterpret_cast<const char*>(raster.values.data()), raster.values.size() * sizeof(double));
  return bytes;
}

}  // namespace sandsim::cli
