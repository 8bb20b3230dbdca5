#include "cli/copy_bandwidth.hpp"

#include <algorithm>
#include <chrono>
#include <memory>
#include <vector>

#include "cli/machine.hpp"

namespace sandsim::cli {

namespace {

/// A copy that multiplies by one: known at run time only, so that no compiler turns the loop into memcpy, which would
/// use non-temporal stores and measure something else than what the solver can reach.
void copy_scaled(const float* from, float* to, std::ptrdiff_t count, float one, int threads) {
#pragma omp parallel for simd schedule(static) num_threads(threads)
  for (std::ptrdiff_t k = 0; k < count; ++k) {
    to[k] = one * from[k];
  }
}

/// Touches the pages from the threads that will use them, or on a machine with several memories all lie in one.
void fill(float* values, std::ptrdiff_t count, float value, int threads) {
#pragma omp parallel for simd schedule(static) num_threads(threads)
  for (std::ptrdiff_t k = 0; k < count; ++k) {
    values[k] = value;
  }
}

}  // namespace

std::size_t copy_array_bytes(bool quick) {
  const std::size_t floor_bytes = std::size_t{quick ? 64u : 256u} << 20;
  const std::size_t most_bytes = std::size_t{1} << 30;
  return std::clamp(4 * last_level_cache(), floor_bytes, most_bytes);
}

Measurement measure_copy_bandwidth(std::size_t array_bytes, int threads, int repeats) {
  const auto count = static_cast<std::ptrdiff_t>(array_bytes / sizeof(float));
  const auto from = std::make_unique_for_overwrite<float[]>(static_cast<std::size_t>(count));
  const auto to = std::make_unique_for_overwrite<float[]>(static_cast<std::size_t>(count));
  fill(from.get(), count, 1.25f, threads);
  fill(to.get(), count, 0.0f, threads);
  const volatile float one = 1.0f;
  copy_scaled(from.get(), to.get(), count, one, threads);
  std::vector<double> rates;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    const auto begin = std::chrono::steady_clock::now();
    copy_scaled(from.get(), to.get(), count, one, threads);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    rates.push_back(2.0 * static_cast<double>(array_bytes) / seconds.count());
  }
  return summarise(std::move(rates));
}

}  // namespace sandsim::cli
