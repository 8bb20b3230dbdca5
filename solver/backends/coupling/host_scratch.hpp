// The memory with which a host couples objects.
#pragma once

#include <vector>

#include "solver/backends/coupling/job.hpp"

namespace sandsim::coupling {

class HostScratch {
 public:
  /// Couples the object of `job`, whose memory is filled in here. R: float or double.
  template <class R>
  CouplingSums couple(Job<R> job, Coupling coupling);

 private:
  std::vector<double> values_;
  std::vector<int> levels_;
};

}  // namespace sandsim::coupling
