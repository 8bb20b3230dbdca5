// The memory and the block of threads with which a host couples objects.
#pragma once

#include <cstddef>
#include <vector>

#include "solver/backends/coupling/couple.hpp"
#include "solver/backends/tiles/block.hpp"

namespace sandsim::coupling {

class HostScratch {
 public:
  /// Couples the object of `job`, whose memory is filled in here.
  template <class R>
  CouplingSums couple(Job<R> job, Coupling coupling) {
    const auto cells = static_cast<std::size_t>(job.patch.cells());
    if (levels_.size() < cells) {
      levels_.resize(cells);
      values_.resize(cells * scratch_rows);
    }
    CouplingSums sums;
    job.scratch = values_.data(), job.levels = levels_.data(), job.sums = &sums;
    alignas(16) std::byte shared[tiles::block_sum_bytes];
    tiles::HostBlock block({sum_lanes, 1}, {1, 1}, 0, 0, shared);
    coupling::couple(block, job, coupling);
    return sums;
  }

 private:
  std::vector<double> values_;
  std::vector<int> levels_;
};

}  // namespace sandsim::coupling
