#include "solver/report.hpp"

#include <algorithm>
#include <limits>

namespace sandsim {

double Ledger::error() const {
  const double brought = std::max(initial + in, std::numeric_limits<double>::min());
  return (final - initial - in + out) / brought;
}

}  // namespace sandsim
