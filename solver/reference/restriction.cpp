#include "solver/reference/restriction.hpp"

#include <algorithm>
#include <cmath>

namespace sandsim {
namespace {

/// The part of a coarse cell that one fine cell makes up.
struct Share {
  std::size_t fine;
  double weight;
};

/// The shares of coarse cell `k` along an axis of `fine_count` cells; `ratio` is coarse over fine spacing.
std::vector<Share> shares(std::size_t k, double ratio, std::size_t fine_count) {
  const double whole = std::round(ratio);
  // Spacings are decimal fractions: a ratio that is whole up to rounding is meant to be whole.
  const double cells = std::abs(ratio - whole) <= 1e-9 * whole ? whole : ratio;
  const double from = static_cast<double>(k) * cells, to = from + cells;
  std::vector<Share> result;
  for (auto i = static_cast<std::size_t>(from); i < fine_count && static_cast<double>(i) < to; ++i) {
    const double covered = std::min(to, static_cast<double>(i + 1)) - std::max(from, static_cast<double>(i));
    if (covered > 0.0) result.push_back({i, covered / cells});
  }
  return result;
}

}  // namespace

std::vector<double> restrict_to(const Grid& coarse, const Grid& fine, std::span<const double> values) {
  const double ratio = coarse.spacing / fine.spacing;
  const auto fine_x = static_cast<std::size_t>(fine.cells[0]), fine_y = static_cast<std::size_t>(fine.cells[1]);
  std::vector<double> means;
  means.reserve(coarse.cell_count());
  for (std::size_t j = 0; j < static_cast<std::size_t>(coarse.cells[1]); ++j) {
    const std::vector<Share> rows = coarse.one_dimensional() ? std::vector<Share>{{0, 1.0}} : shares(j, ratio, fine_y);
    for (std::size_t i = 0; i < static_cast<std::size_t>(coarse.cells[0]); ++i) {
      double mean = 0.0;
      const std::vector<Share> columns = shares(i, ratio, fine_x);
      for (const Share& row : rows) {
        for (const Share& column : columns) {
          mean += row.weight * column.weight * values[row.fine * fine_x + column.fine];
        }
      }
      means.push_back(mean);
    }
  }
  return means;
}

}  // namespace sandsim
