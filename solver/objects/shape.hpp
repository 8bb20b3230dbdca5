// A shape: primitives joined by set operations, or a sampled signed distance.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "solver/objects/bounds.hpp"
#include "solver/objects/distance.hpp"
#include "solver/objects/distance_grid.hpp"

namespace sandsim::objects {

/// The most primitives of a shape, and the most intervals that a line has inside one: lists of them live in registers
/// and on the stack. The set operations cannot make more intervals than there are primitives.
inline constexpr int most_primitives = 16;
inline constexpr int most_intervals = 16;

/// An instruction of a shape in reverse Polish notation: `primitive` pushes the next primitive, the others take the two
/// uppermost operands a, b off the stack and push a or b, a and b, a and not b.
enum class Instruction : int { primitive, unite, intersect, subtract };

/// View of a shape that kernels take by value; the arrays live as long as the shape. With a grid there is nothing else.
struct ShapeView {
  const Primitive* primitives = nullptr;
  const Instruction* instructions = nullptr;
  int primitive_count = 0;
  int instruction_count = 0;
  DistanceGridView grid;
  Pose grid_pose;

  SANDSIM_HD bool is_sampled() const { return grid.values != nullptr; }
};

class Shape {
 public:
  /// Throws std::invalid_argument unless the instructions use each primitive once and leave one operand.
  Shape(std::vector<Primitive> primitives, std::vector<Instruction> instructions);
  explicit Shape(const Primitive& primitive) : Shape({primitive}, {Instruction::primitive}) {}
  /// `grid` lies at `pose` in the frame of the shape. Throws std::invalid_argument if the grid is no grid.
  explicit Shape(std::shared_ptr<const DistanceGrid> grid, const Pose& pose = {});

  ShapeView view() const;
  /// Box around the shape when its frame lies at `pose`. Empty if nothing is inside.
  Bounds bounds(const Pose& pose) const;
  bool is_sampled() const { return grid_ != nullptr; }

 private:
  std::vector<Primitive> primitives_;
  std::vector<Instruction> instructions_;
  std::shared_ptr<const DistanceGrid> grid_;
  Pose grid_pose_;
  Bounds grid_bounds_;  // of the inside, in the grid's frame
};

/// Ascending intervals that do not touch.
struct Intervals {
  int count = 0;
  Interval items[most_intervals];
};

/// Signed distance [m]: the primitives' own for one of them; of set operations the usual minimum and maximum, whose
/// sign is exact and whose size is at most the distance outside unions, and a lower bound elsewhere.
SANDSIM_HD double distance(const ShapeView& shape, const Vec3& point) {
  if (shape.is_sampled()) return distance(shape.grid, to_local(shape.grid_pose, point));
  double stack[most_primitives];
  int top = 0;
  int next = 0;
  for (int k = 0; k < shape.instruction_count; ++k) {
    if (shape.instructions[k] == Instruction::primitive) {
      stack[top++] = distance(shape.primitives[next++], point);
      continue;
    }
    const double b = stack[--top];
    const double a = stack[top - 1];
    stack[top - 1] = shape.instructions[k] == Instruction::unite       ? detail::smaller(a, b)
                     : shape.instructions[k] == Instruction::intersect ? detail::larger(a, b)
                                                                       : detail::larger(a, -b);
  }
  return stack[0];
}

namespace detail {

/// Whether a point is inside the shape that is inside the primitives whose bits are set. The stack is one bit deep a
/// level.
SANDSIM_HD bool is_inside(const ShapeView& shape, std::uint32_t inside_primitives) {
  std::uint32_t stack = 0;
  for (int k = 0; k < shape.instruction_count; ++k) {
    if (shape.instructions[k] == Instruction::primitive) {
      stack = stack << 1 | (inside_primitives & 1U);
      inside_primitives >>= 1;
      continue;
    }
    const std::uint32_t b = stack & 1U;
    const std::uint32_t a = stack >> 1 & 1U;
    const std::uint32_t result = shape.instructions[k] == Instruction::unite       ? (a | b)
                                 : shape.instructions[k] == Instruction::intersect ? (a & b)
                                                                                   : (a & (b ^ 1U));
    stack = (stack >> 2) << 1 | result;
  }
  return (stack & 1U) != 0;
}

/// Adds an interval behind the others, joined to the last one if they touch. A list that is full keeps its last
/// interval's end up to date, so that no volume beyond it is lost.
SANDSIM_HD void append(Intervals& list, const Interval& next) {
  if (next.empty()) return;
  const bool joins = list.count > 0 && list.items[list.count - 1].to >= next.from;
  if (joins || list.count == most_intervals) {
    list.items[list.count - 1].to = next.to;
  } else {
    list.items[list.count++] = next;
  }
}

SANDSIM_HD Intervals inside_primitives(const ShapeView& shape, const Line& line, const Interval& range) {
  Interval own[most_primitives];
  double ends[2 * most_primitives + 2] = {};
  int count = 0;
  const auto insert = [&](double end) {
    int place = count++;
    for (; place > 0 && ends[place - 1] > end; --place) ends[place] = ends[place - 1];
    ends[place] = end;
  };
  insert(range.from);
  insert(range.to);
  for (int k = 0; k < shape.primitive_count; ++k) {
    own[k] = intersection(inside(shape.primitives[k], line), range);
    if (own[k].empty()) continue;
    insert(own[k].from);
    insert(own[k].to);
  }
  // Between two neighbouring ends nothing changes.
  Intervals result;
  for (int k = 0; k + 1 < count; ++k) {
    std::uint32_t bits = 0;
    for (int p = 0; p < shape.primitive_count; ++p) {
      const bool covers = !own[p].empty() && own[p].from <= ends[k] && own[p].to >= ends[k + 1];
      bits |= (covers ? 1U : 0U) << p;
    }
    if (is_inside(shape, bits)) append(result, {ends[k], ends[k + 1]});
  }
  return result;
}

SANDSIM_HD Intervals inside_grid(const DistanceGridView& grid, const Line& line, const Interval& range,
                                 double spacing) {
  const Vec3 half = 0.5 * grid.spacing * Vec3{grid.nx - 1.0, grid.ny - 1.0, grid.nz - 1.0};
  const Line centered{line.origin - grid.origin - half, line.direction};
  const Interval part = intersection(range, inside_own_frame({PrimitiveKind::box, half, {}}, centered));
  Intervals result;
  if (part.empty()) return result;
  // Within an eighth of a cell the interpolated distance is nearly straight: finer samples show nothing new.
  const double finest = 0.125 * grid.spacing;
  const double wanted = (part.to - part.from) * length(line.direction) / (spacing > finest ? spacing : finest);
  const int steps = wanted > 1.0 ? static_cast<int>(std::ceil(wanted)) : 1;
  const double step = (part.to - part.from) / steps;
  double before = distance(grid, line.origin + part.from * line.direction);
  double entry = part.from;
  for (int k = 1; k <= steps; ++k) {
    const double t = k == steps ? part.to : part.from + k * step;
    const double now = distance(grid, line.origin + t * line.direction);
    // The surface between two samples is where the straight line between them crosses 0.
    const double crossing = t - step * now / (now - before);
    if (before >= 0.0 && now < 0.0) entry = crossing;
    if (before < 0.0 && now >= 0.0) append(result, {entry, crossing});
    before = now;
  }
  if (before < 0.0) append(result, {entry, part.to});
  return result;
}

}  // namespace detail

/// The parts of a line inside the shape, within `range`. Exact to rounding for primitives; a sampled shape is looked
/// at every `spacing` [m] or an eighth of the grid's, whichever is larger, so that what is thinner than that may be
/// missed. Endless ranges are allowed.
SANDSIM_HD Intervals inside(const ShapeView& shape, const Line& line, const Interval& range, double spacing) {
  if (range.empty()) return {};
  if (!shape.is_sampled()) return detail::inside_primitives(shape, line, range);
  const Line local{to_local(shape.grid_pose, line.origin),
                   rotate(inverse(shape.grid_pose.orientation), line.direction)};
  return detail::inside_grid(shape.grid, local, range, spacing);
}

}  // namespace sandsim::objects
