// The arithmetic that the laws of this folder are written in. Only + - * / and sqrt, which round alike on every IEEE
// machine, and selections instead of branches, so that a loop over cells can be vectorised.
#pragma once

#include <cmath>

#if defined(__CUDACC__)
#define SANDSIM_HD __host__ __device__ __forceinline__
#else
#define SANDSIM_HD inline __attribute__((always_inline))
#endif

namespace sandsim::physics {

template <class R>
SANDSIM_HD R minimum(R a, R b) {
  return b < a ? b : a;
}
template <class R>
SANDSIM_HD R maximum(R a, R b) {
  return a < b ? b : a;
}
template <class R>
SANDSIM_HD R clamp(R x, R low, R high) {
  return maximum(low, minimum(high, x));
}
template <class R>
SANDSIM_HD R absolute(R x) {
  return std::fabs(x);
}
template <class R>
SANDSIM_HD R square_root(R x) {
  return std::sqrt(x);
}
template <class R>
SANDSIM_HD R length(R x, R y) {
  return std::sqrt(x * x + y * y);
}

/// The smaller of two differences of one sign, else 0.
template <class R>
SANDSIM_HD R minmod(R a, R b) {
  const R smaller = absolute(a) < absolute(b) ? a : b;
  return a * b <= R(0) ? R(0) : smaller;
}

/// Monotonised central limiter of two differences (van Leer 1977).
template <class R>
SANDSIM_HD R monotonised_central(R a, R b) {
  const R size_a = absolute(a), size_b = absolute(b);
  const R limited = std::copysign(minimum(2 * minimum(size_a, size_b), R(0.5) * (size_a + size_b)), a);
  return a * b <= R(0) ? R(0) : limited;
}

}  // namespace sandsim::physics
