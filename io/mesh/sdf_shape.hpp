// How many samples a signed distance may have.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string>

namespace sandsim {

/// The most samples along an axis, and in all: 2 GiB as float32.
inline constexpr std::uint64_t most_along_axis = 1U << 16;
inline constexpr std::uint64_t most_samples = std::uint64_t{1} << 29;

/// Empty if a grid may have so many samples along its axes; else what is wrong with them.
inline std::string shape_problem(std::uint64_t nx, std::uint64_t ny, std::uint64_t nz) {
  const std::string shape = fmt::format("{} x {} x {} samples along x, y, z", nx, ny, nz);
  if (std::min({nx, ny, nz}) < 2) return shape + " (two are needed along each axis)";
  if (std::max({nx, ny, nz}) > most_along_axis || nx * ny * nz > most_samples) {
    return fmt::format("{} (at most {} along an axis and {} in all are read)", shape, most_along_axis, most_samples);
  }
  return {};
}

}  // namespace sandsim
