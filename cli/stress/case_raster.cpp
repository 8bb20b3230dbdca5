#include "cli/stress/case_raster.hpp"

#include <random>

namespace sandsim::cli {

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

}  // namespace sandsim::cli
