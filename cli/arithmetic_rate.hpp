// How fast this machine does the arithmetic of a step.
#pragma once

#include "cli/measurement.hpp"
#include "solver/scene.hpp"

namespace sandsim::cli {

/// Operations a second over all threads, in packs of cells, on values that stay in registers.
struct ArithmeticRate {
  Measurement simple;   // additions and multiplications in equal parts
  Measurement divided;  // divisions and square roots in equal parts
};

ArithmeticRate measure_arithmetic(Precision precision, int threads, int repeats);

}  // namespace sandsim::cli
