// How much arithmetic a step asks for: the laws of solver/physics run on numbers that count.
#pragma once

namespace sandsim::cli {

/// Operations of one cell in one step, as the laws are written, without what is the same for every cell.
struct OperationCount {
  int simple = 0;   // + - * comparisons, selections, signs
  int divided = 0;  // divisions and square roots, which are an order slower
};

/// Two dimensions, uniform material, the speed of the next step's bound included.
/// `paper`: the paper's scheme, else the balanced one of `order` 1 or 2.
OperationCount count_operations(bool paper, int order, bool flat);

}  // namespace sandsim::cli
