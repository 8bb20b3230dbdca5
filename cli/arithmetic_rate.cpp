#include "cli/arithmetic_rate.hpp"

#include <omp.h>

#include <array>
#include <chrono>
#include <vector>

#include "solver/backends/cpu/pack.hpp"

namespace sandsim::cli {
namespace {

constexpr int chains = 12;  // independent results: enough to hide the latency of an operation
constexpr int rounds = 200000;

/// One round of the chains; every operation depends on the round before only.
template <class V>
using Round = void (*)(std::array<V, chains>& values);

template <class V>
void add_and_multiply(std::array<V, chains>& values) {
  for (std::size_t k = 0; k < chains; ++k) {
    values[k] = k % 2 == 0 ? values[k] + V(1e-3f) : values[k] * V(0.999f);
  }
}

template <class V>
void divide_and_root(std::array<V, chains>& values) {
  for (std::size_t k = 0; k < chains; ++k) {
    values[k] = k % 2 == 0 ? V(2.0f) / values[k] : sqrt(values[k]);
  }
}

/// Operations a second of `round` on all threads.
template <class R, Round<cpu::Pack<R>> round>
Measurement measure(int threads, int repeats, int count) {
  using V = cpu::Pack<R>;
  std::vector<double> rates;
  double kept = 0.0;  // keeps the compiler from dropping the work
  for (int repeat = 0; repeat < repeats; ++repeat) {
    const auto start = std::chrono::steady_clock::now();
#pragma omp parallel num_threads(threads) reduction(+ : kept)
    {
      std::array<V, chains> values;
      values.fill(V(1.5f));
      for (int k = 0; k < count; ++k) {
        round(values);
      }
      for (const V& value : values) {
        kept += static_cast<double>(reduce(value));
      }
    }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    rates.push_back(1.0 * chains * count * static_cast<double>(V::size()) * threads / seconds);
  }
  return kept > 0.0 ? summarise(rates) : Measurement{};
}

template <class R>
ArithmeticRate measure_in(int threads, int repeats) {
  return {measure<R, add_and_multiply<cpu::Pack<R>>>(threads, repeats, 20 * rounds),
          measure<R, divide_and_root<cpu::Pack<R>>>(threads, repeats, rounds)};
}

}  // namespace

ArithmeticRate measure_arithmetic(Precision precision, int threads, int repeats) {
  return precision == Precision::float32 ? measure_in<float>(threads, repeats) : measure_in<double>(threads, repeats);
}

}  // namespace sandsim::cli
