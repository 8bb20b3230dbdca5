#include "solver/objects/shape.hpp"

#include <stdexcept>
#include <utility>

namespace sandsim::objects {

namespace {

/// Runs the instructions on boxes.
Bounds combined_bounds(const std::vector<Primitive>& primitives, const std::vector<Instruction>& instructions,
                       const Pose& pose) {
  std::vector<Bounds> stack;
  auto next = primitives.begin();
  for (const Instruction instruction : instructions) {
    if (instruction == Instruction::primitive) {
      stack.push_back(around(*next++, pose));
      continue;
    }
    const Bounds b = stack.back();
    stack.pop_back();
    if (instruction == Instruction::unite) stack.back() = unite(stack.back(), b);
    if (instruction == Instruction::intersect) stack.back() = intersect(stack.back(), b);
  }
  return stack.back();
}

}  // namespace

Shape::Shape(std::vector<Primitive> primitives, std::vector<Instruction> instructions)
    : primitives_(std::move(primitives)), instructions_(std::move(instructions)) {
  std::size_t pushed = 0;
  std::size_t depth = 0;
  for (const Instruction instruction : instructions_) {
    if (instruction == Instruction::primitive) {
      ++pushed;
      ++depth;
    } else if (depth < 2) {
      throw std::invalid_argument("a set operation lacks an operand");
    } else {
      --depth;
    }
  }
  if (depth != 1 || pushed != primitives_.size()) throw std::invalid_argument("a shape leaves operands unused");
  if (pushed > most_primitives) throw std::invalid_argument("a shape has too many primitives");
}

Shape::Shape(std::shared_ptr<const DistanceGrid> grid, const Pose& pose) : grid_(std::move(grid)), grid_pose_(pose) {
  std::size_t count = 1;
  for (const int points : grid_->points) {
    if (points < 2) throw std::invalid_argument("a grid of distances has two points along each axis, or more");
    count *= static_cast<std::size_t>(points);
  }
  if (count != grid_->values.size() || !(grid_->spacing > 0.0)) {
    throw std::invalid_argument("a grid of distances has one value a point and a spacing above 0");
  }
  grid_bounds_ = inside_bounds(*grid_);
}

ShapeView Shape::view() const {
  ShapeView view{primitives_.data(),
                 instructions_.data(),
                 static_cast<int>(primitives_.size()),
                 static_cast<int>(instructions_.size()),
                 {},
                 grid_pose_};
  if (grid_) view.grid = objects::view(*grid_);
  return view;
}

Bounds Shape::bounds(const Pose& pose) const {
  return grid_ ? around(grid_bounds_, pose * grid_pose_) : combined_bounds(primitives_, instructions_, pose);
}

}  // namespace sandsim::objects
