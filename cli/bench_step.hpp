// The speed of the step alone: no frames, no files, no checks.
#pragma once

#include <string>
#include <vector>

#include "cli/measurement.hpp"
#include "solver/scene.hpp"

namespace sandsim::cli {

/// One line of the table.
struct StepCase {
  Scheme scheme = Scheme::balanced;
  int order = 1;
  Precision precision = Precision::float32;
  bool terrain = false;
};

/// All schemes on flat and on wavy terrain, in the given precisions.
std::vector<StepCase> step_cases(const std::vector<Precision>& precisions);

/// E.g. "balanced order 2".
std::string scheme_name(const StepCase& which);

/// [B] a cell and step of the floor that the project judges by: 28 in float32, which is depth and two momenta, read and
/// written, and one word more; the bed is read where the terrain is not flat.
double floor_bytes(const StepCase& which);

struct StepSpeed {
  Measurement cell_steps_per_second;
  double bytes_per_cell = 0.0;  // [B] that the backend says it moves
  double moving = 0.0;          // fraction of the cells that still moved at the end
};

/// Times `repeats` times `steps` steps on size x size periodic cells, all of them moving, from the same state.
StepSpeed measure_step(const StepCase& which, int size, int threads, int repeats, int steps);

/// [s] from the start of a run to its first step, for a dam break on columns x rows cells.
Measurement measure_start(int columns, int rows, int threads, int repeats);

}  // namespace sandsim::cli
