// A table of (x, y) as a piecewise linear function.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>

namespace sandsim {

/// y over ascending x, piecewise linear, with the end values outside the table. Views: the table must live on, and
/// hold at least one point; x and y have the same size.
class PiecewiseLinear {
 public:
  PiecewiseLinear(std::span<const double> x, std::span<const double> y) : x_(x), y_(y) {}

  double operator()(double x) const {
    const auto above = std::upper_bound(x_.begin(), x_.end(), x);
    if (above == x_.begin()) return y_.front();
    if (above == x_.end()) return y_.back();
    const auto k = static_cast<std::size_t>(above - x_.begin());
    return y_[k - 1] + (y_[k] - y_[k - 1]) * (x - x_[k - 1]) / (x_[k] - x_[k - 1]);
  }

  /// Exact mean over [from, to], from < to: the pieces are trapezoids.
  double mean(double from, double to) const {
    double sum = 0.0, left = from, value = (*this)(from);
    for (auto next = std::upper_bound(x_.begin(), x_.end(), from); next != x_.end() && *next < to; ++next) {
      const double y = y_[static_cast<std::size_t>(next - x_.begin())];
      sum += 0.5 * (value + y) * (*next - left);
      left = *next;
      value = y;
    }
    return (sum + 0.5 * (value + (*this)(to)) * (to - left)) / (to - from);
  }

  /// Largest x at which y crosses `threshold` downwards; the last x if y ends above it, NaN if it is nowhere above.
  double last_crossing(double threshold) const {
    for (std::size_t k = x_.size(); k-- > 0;) {
      if (y_[k] <= threshold) continue;
      if (k + 1 == x_.size()) return x_[k];
      return x_[k] + (x_[k + 1] - x_[k]) * (y_[k] - threshold) / (y_[k] - y_[k + 1]);
    }
    return std::numeric_limits<double>::quiet_NaN();
  }

 private:
  std::span<const double> x_;
  std::span<const double> y_;
};

}  // namespace sandsim
