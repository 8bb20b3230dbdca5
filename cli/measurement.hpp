// Repeated measurements of one number.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace sandsim::cli {

struct Measurement {
  double median = 0.0;
  double least = 0.0;
  double most = 0.0;
};

/// Median and range of at least one value.
inline Measurement summarise(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  const double median = values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
  return {median, values.front(), values.back()};
}

}  // namespace sandsim::cli
