#include "solver/reference/exact_now.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>
#include <vector>

#include "solver/reference/dam_break.hpp"
#include "solver/reference/stoker.hpp"
#include "solver/reference/two_layer_dam_break.hpp"

namespace sandsim {
namespace {

/// The one value of a map, if it has only one.
std::optional<double> uniform(const std::vector<double>& map) {
  if (map.empty()) return std::nullopt;
  const auto differs = [&](double value) { return value != map.front(); };
  if (std::any_of(map.begin(), map.end(), differs)) return std::nullopt;
  return map.front();
}

/// tan of the angle by which the bed falls along x, if it is a plane.
std::optional<double> uniform_slope(const Grid& grid, const std::vector<double>& bed) {
  if (bed.size() < 2) return 0.0;
  const std::size_t last = bed.size() - 1;
  const double fall = (bed.front() - bed.back()) / (static_cast<double>(last) * grid.spacing);
  for (std::size_t i = 0; i <= last; ++i) {
    const double plane = bed.front() - fall * static_cast<double>(i) * grid.spacing;
    // A millionth of a spacing: far above the rounding of a bed in metres, far below what a flow would notice.
    if (std::abs(bed[i] - plane) > 1e-6 * grid.spacing) return std::nullopt;
  }
  // Rounding of the elevations must not turn a flat bed into a slope.
  return std::abs(fall) < 1e-12 ? 0.0 : fall;
}

/// True if the initial sand is `depth` deep before the dam and `downstream` after it.
bool starts_as_dam(const Grid& grid, const std::vector<double>& sand, double dam, double depth, double downstream) {
  for (int i = 0; i < grid.cells[0]; ++i) {
    const double covered = std::clamp((dam - grid.origin[0]) / grid.spacing - i, 0.0, 1.0);
    const double expected = downstream + covered * (depth - downstream);
    // A millionth of the depth allows for a dam that lies on a cell's face up to rounding.
    if (std::abs(sand[static_cast<std::size_t>(i)] - expected) > 1e-6 * depth) return false;
  }
  return true;
}

/// What all dam breaks need of a scene, or the reason why none applies.
struct Setting {
  std::string problem;
  double alpha = 1.0, cap = 1e30, net_slope = 0.0, gravity = 0.0;
  double left = 0.0, right = 0.0;  // [m] ends of the grid
  bool right_is_wall = true;
};

Setting describe(const Scene& scene, const InitialState& initial) {
  Setting setting;
  const Grid& grid = scene.grid;
  setting.gravity = scene.gravity;
  setting.left = grid.origin[0];
  setting.right = grid.origin[0] + grid.cells[0] * grid.spacing;
  setting.right_is_wall = scene.boundaries.x_max == BoundaryKind::wall;
  const auto mu = uniform(initial.friction_coefficient);
  const auto alpha = uniform(initial.hbar_scale);
  const auto cap = uniform(initial.hbar_cap);
  const auto slope = grid.one_dimensional() ? uniform_slope(grid, initial.bed) : std::nullopt;
  if (!grid.one_dimensional()) {
    setting.problem = "the scene is not one-dimensional";
  } else if (!mu || !alpha || !cap) {
    setting.problem = "friction or hbar vary over the grid";
  } else if (!slope) {
    setting.problem = "the bed is not a plane";
  } else if (!scene.sand.sources.empty()) {
    setting.problem = "the scene has sources of sand";
  } else if (scene.boundaries.x_min == BoundaryKind::periodic || scene.boundaries.x_max == BoundaryKind::periodic) {
    setting.problem = "the boundaries are periodic";
  } else {
    setting.alpha = *alpha;
    setting.cap = *cap;
    setting.net_slope = *slope - *mu;
    // tan(angle) on both sides differs by rounding where the slope stands exactly at the friction angle.
    if (std::abs(setting.net_slope) <= 1e-12 * *mu) setting.net_slope = 0.0;
  }
  return setting;
}

/// Common end: a tip beyond the grid ends all knowledge (with a wall), or that of the tip (open end).
void limit_to_grid(ExactNow& now, const Setting& setting) {
  if (now.tip <= setting.right) return;
  now.tip = std::numeric_limits<double>::quiet_NaN();
  if (setting.right_is_wall) {
    now.depth = nullptr;
    now.problem = "the sand has reached the end of the grid";
  } else {
    now.limit = "the tip has left the grid";
  }
}

constexpr const char* not_this_dam = "the initial sand is not that of the reference";
constexpr const char* tip_only = "only the tip is known: friction stops the sand";

ExactNow evaluate(const DamBreakReference& dam, const Setting& setting, double time) {
  ExactNow now;
  now.name = "exact dam break";
  if (setting.cap < setting.alpha * dam.depth) {
    now.problem = "the cap of hbar acts: use the two-layer dam break";
    return now;
  }
  const double gravity = setting.alpha * setting.gravity;
  const DamBreak exact(dam.dam, dam.depth, gravity, gravity * setting.net_slope);
  now.tip = exact.tip(time);
  if (exact.has_profile()) {
    now.depth = [=](double x) { return exact.depth(x, time); };
    now.from = exact.wall_influence(setting.left, time);
  } else {
    now.limit = tip_only;
  }
  limit_to_grid(now, setting);
  return now;
}

ExactNow evaluate(const StokerReference& dam, const Setting& setting, double time) {
  ExactNow now;
  now.name = "Stoker's dam break";
  if (setting.net_slope != 0.0) {
    now.problem = "the sand has friction that the slope does not balance";
  } else if (setting.cap < setting.alpha * dam.depth) {
    now.problem = "the cap of hbar acts";
  } else {
    const StokerDamBreak exact(dam.dam, dam.depth, dam.downstream_depth, setting.alpha * setting.gravity);
    now.tip = exact.shock(time);
    now.depth = [=](double x) { return exact.depth(x, time); };
    if (time > exact.wall_time(setting.left)) {
      now.depth = nullptr;
      now.limit = "the fan has reached the wall: only the shock is known";
    }
    limit_to_grid(now, setting);
  }
  return now;
}

ExactNow evaluate(const TwoLayerDamBreakReference& dam, const Setting& setting, double time) {
  ExactNow now;
  now.name = "two-layer dam break";
  const TwoLayerDamBreak exact(dam.dam, dam.depth, setting.alpha, setting.cap, setting.gravity, setting.net_slope);
  now.tip = exact.tip(time);
  if (!exact.has_profile()) {
    now.limit = setting.net_slope < 0.0 ? tip_only : "only the tip is known: the slope is steeper than friction";
  } else if (time > exact.wall_time(setting.left)) {
    now.limit = "the fan has reached the wall: only the tip is known";
  } else {
    now.depth = [=](double x) { return exact.depth(x, time); };
  }
  limit_to_grid(now, setting);
  return now;
}

}  // namespace

ExactNow exact_now(const Scene& scene, const InitialState& initial, double time) {
  const Setting setting = describe(scene, initial);
  const auto visitor = [&](const auto& dam) {
    double downstream = 0.0;
    if constexpr (requires { dam.downstream_depth; }) downstream = dam.downstream_depth;
    const ExactNow now = evaluate(dam, setting, time);
    std::string problem = setting.problem;
    if (problem.empty() && !starts_as_dam(scene.grid, initial.depth, dam.dam, dam.depth, downstream)) {
      problem = not_this_dam;
    }
    if (problem.empty()) return now;
    ExactNow nothing;
    nothing.name = now.name;
    nothing.problem = problem;
    return nothing;
  };
  return std::visit(visitor, *scene.reference->exact);
}

}  // namespace sandsim
