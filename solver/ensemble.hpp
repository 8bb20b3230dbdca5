// Many small runs side by side: a device takes them in one launch.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "solver/backend.hpp"

namespace sandsim {

/// What a run of an ensemble starts from.
struct EnsembleMember {
  BackendConfig config;
  InitialState initial;
};

/// Runs that share their scheme and precision; grids, materials, initial states and steps are each run's own.
class Ensemble {
 public:
  virtual ~Ensemble() = default;

  virtual std::size_t size() const = 0;
  /// A run by itself: its state, frames, speeds.
  virtual Backend& member(std::size_t k) = 0;
  /// Backend::advance() of every run whose loop is not halted, side by side; loops[k] and rules[k] are those of run k.
  virtual void advance(std::vector<StepLoop>& loops, const std::vector<StepRules>& rules, std::int64_t most) = 0;
};

/// Most cells along x of a run in an ensemble.
inline constexpr int ensemble_columns = 250;

/// On the first CUDA device. Throws DeviceError, and std::invalid_argument if the runs do not share their scheme or one
/// is too wide.
std::unique_ptr<Ensemble> make_cuda_ensemble(const std::vector<EnsembleMember>& members);

}  // namespace sandsim
