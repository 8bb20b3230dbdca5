#include "solver/backends/coupling/host_scratch.hpp"

#include <cstddef>

#include "solver/backends/coupling/couple.hpp"
#include "solver/backends/tiles/block.hpp"

namespace sandsim::coupling {

template <class R>
CouplingSums HostScratch::couple(Job<R> job, Coupling coupling) {
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

template CouplingSums HostScratch::couple(Job<float> job, Coupling coupling);
template CouplingSums HostScratch::couple(Job<double> job, Coupling coupling);

}  // namespace sandsim::coupling
