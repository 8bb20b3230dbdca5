// The arithmetic that the laws of this folder are written in. Only + - * / and sqrt, which round alike on every IEEE
// machine, and selections instead of branches. R is float or double, or a pack of them (std::experimental::simd), of
// which every lane is one cell.
#pragma once

#include <cmath>
#include <limits>
#include <type_traits>

#if defined(__CUDACC__)
#define SANDSIM_HD __host__ __device__ __forceinline__
#else
#define SANDSIM_HD inline __attribute__((always_inline))
#endif

namespace sandsim::physics {

/// float or double: R itself, or what a pack's lanes hold.
template <class R>
struct ScalarOf {
  using type = R;
};
template <class R>
requires requires {
  typename R::value_type;
}
struct ScalarOf<R> {
  using type = typename R::value_type;
};
template <class R>
using Scalar = typename ScalarOf<R>::type;

template <class R>
inline constexpr R largest_number = std::numeric_limits<R>::max();
template <class R>
inline constexpr Scalar<R> unit_rounding = std::numeric_limits<Scalar<R>>::epsilon();
template <class R>
inline constexpr R infinity = std::numeric_limits<R>::infinity();

/// The result of a comparison: bool, or one a lane.
template <class R>
using Mask = decltype(R() < R());

/// A constant that is not exact in float.
template <class R>
SANDSIM_HD R constant(double value) {
  return R(static_cast<Scalar<R>>(value));
}

/// yes where the mask is set, else no.
template <class M, class R>
SANDSIM_HD R select(M mask, R yes, R no) {
  if constexpr (std::is_integral_v<M>) {
    return mask ? yes : no;
  } else {
    where(mask, no) = yes;
    return no;
  }
}

/// Whether the mask is set in some lane, or in every lane: then work that no lane needs can be left out. What is left
/// out never changes a result.
template <class M>
SANDSIM_HD bool any(M mask) {
  if constexpr (std::is_integral_v<M>) {
    return mask;
  } else {
    return any_of(mask);
  }
}
template <class M>
SANDSIM_HD bool every(M mask) {
  if constexpr (std::is_integral_v<M>) {
    return mask;
  } else {
    return all_of(mask);
  }
}

template <class R>
SANDSIM_HD R minimum(R a, R b) {
  return select(b < a, b, a);
}
template <class R>
SANDSIM_HD R maximum(R a, R b) {
  return select(a < b, b, a);
}
template <class R>
SANDSIM_HD R clamp(R x, R low, R high) {
  return maximum(low, minimum(high, x));
}
template <class R>
SANDSIM_HD R absolute(R x) {
  using std::fabs;
  return fabs(x);
}
template <class R>
SANDSIM_HD R square_root(R x) {
  using std::sqrt;
  return sqrt(x);
}
template <class R>
SANDSIM_HD R length(R x, R y) {
  return square_root(x * x + y * y);
}

/// The smaller of two differences of one sign, else 0.
template <class R>
SANDSIM_HD R minmod(R a, R b) {
  return select(a * b <= R(0), R(0), select(absolute(a) < absolute(b), a, b));
}

/// Monotonised central limiter of two differences (van Leer 1977).
template <class R>
SANDSIM_HD R monotonised_central(R a, R b) {
  const R size_a = absolute(a), size_b = absolute(b);
  const R size = minimum(2 * minimum(size_a, size_b), R(0.5f) * (size_a + size_b));
  return select(a * b <= R(0), R(0), select(a < R(0), -size, size));
}

}  // namespace sandsim::physics
