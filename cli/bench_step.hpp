// The speed of the step alone, without files and checks, and what a frame and a start cost.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "cli/bench_state.hpp"
#include "cli/measurement.hpp"
#include "solver/device.hpp"
#include "solver/ensemble.hpp"

namespace sandsim::cli {

using MakeBackend = std::function<std::unique_ptr<Backend>(const BackendConfig&, const InitialState&)>;

using MakeEnsemble = std::function<std::unique_ptr<Ensemble>(const std::vector<EnsembleMember>&)>;

struct StepSpeed {
  Measurement cell_steps_per_second;
  double bytes_per_cell = 0.0;  // [B] that the backend says it moves
  double moving = 0.0;          // fraction of the cells that still moved at the end
};

/// Times `repeats` times `steps` steps on size x size periodic cells, in loops as a run has them from frame to frame.
/// All cells move: `moving` is the state to start from.
StepSpeed measure_step(const MakeBackend& make, const StepCase& which, int size, const StateArrays& moving, int threads,
                       int repeats, int steps);

/// A frame that is taken after every step.
struct FrameCost {
  Measurement with_frame;  // [s] a step, and a copy of depth and velocity that is begun before it and ended after it
  Measurement step;        // [s] a step of a long loop
  double overhead() const { return with_frame.median - step.median; }
};
FrameCost measure_frame(const MakeBackend& make, const StepCase& which, int size, int threads, int repeats);

/// Steps of `runs` runs of size x size cells side by side, summed over the runs. [1/s]
Measurement measure_ensemble(const MakeEnsemble& make, const StepCase& which, int size, int runs, int repeats);

/// [s] from the start of a run to its first step, for a dam break on columns x rows cells.
Measurement measure_start(Device device, int columns, int rows, int threads, int repeats);

}  // namespace sandsim::cli
