// What the bench steps: sand that moves everywhere, on a periodic grid.
#pragma once

#include <string>
#include <vector>

#include "solver/backend.hpp"

namespace sandsim::cli {

/// A kind of step.
struct StepCase {
  Scheme scheme = Scheme::balanced;
  int order = 1;
  Precision precision = Precision::float32;
  bool terrain = false;
};

/// All schemes on flat and on wavy terrain.
std::vector<StepCase> step_cases(Precision precision);

/// E.g. "balanced order 2".
std::string scheme_name(const StepCase& which);
const char* precision_name(Precision precision);

/// [B] a cell and step of the floor that the project judges by: 28 in float32, which is depth and two momenta, read and
/// written, and one word more; the bed is read where the terrain is not flat.
double floor_bytes(const StepCase& which);

/// size x size periodic cells.
BackendConfig bench_config(const StepCase& which, int size, int threads);
InitialState bench_initial(const StepCase& which, int size);

/// Sand 14 to 26 cm deep that moves at 3 m/s along x and 1 m/s along y, give or take half a metre per second: friction
/// needs more than `steps_that_move` steps to stop any of it (1040 for order 1, 1600 and more for the others).
StateArrays moving_state(Precision precision, int size);
inline constexpr int steps_that_move = 1000;

/// [B] that the arrays of a bench on size x size cells take on the host, those of the backend included.
double bench_host_bytes(Precision precision, int size);

}  // namespace sandsim::cli
