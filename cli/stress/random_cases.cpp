// Scenes drawn at random from everything that the other themes vary one by one.
#include <fmt/format.h>

#include <cmath>
#include <random>

#include "cli/stress/case_raster.hpp"
#include "cli/stress/matrix.hpp"

namespace sandsim::cli {

namespace {

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : random_(seed) {}

  double even(double low, double high) { return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1p-53; }
  /// Even in the exponent.
  double decades(double low, double high) { return std::exp(even(std::log(low), std::log(high))); }
  bool chance(double part) { return even(0.0, 1.0) < part; }
  std::uint64_t seed() { return random_(); }

 private:
  std::mt19937_64 random_;
};

/// One random scene in the making.
class Draw {
 public:
  explicit Draw(std::uint64_t number);
  StressCase make() &&;

 private:
  void choose_sizes();
  void choose_ground();
  void choose_friction();
  void choose_hbar();
  void choose_sand();
  void choose_sides();
  std::string raster(const std::string& what, double low, double high, bool by_decades);

  Dice dice_;
  StressCase made_;
  int nx_ = 0, ny_ = 0;
  double spacing_ = 0.0, gravity_ = 0.0, depth_ = 0.0, speed_ = 0.0, height_ = 0.0;  // [m], [m/s^2], [m/s]
};

Draw::Draw(std::uint64_t number) : dice_(number), made_{fmt::format("random_{:03}", number), "", {}} {
  choose_sizes();
  choose_ground();
  choose_friction();
  choose_hbar();
  choose_sand();
  choose_sides();
}

std::string Draw::raster(const std::string& what, double low, double high, bool by_decades) {
  const std::string file = fmt::format("{}_{}.npy", made_.name, what);
  Dice own(dice_.seed());
  made_.rasters.push_back(
      make_raster(file, nx_, ny_, [&](int, int) { return by_decades ? own.decades(low, high) : own.even(low, high); }));
  return file;
}

void Draw::choose_sizes() {
  nx_ = static_cast<int>(dice_.even(2.0, 40.0)), ny_ = dice_.chance(0.25) ? 1 : static_cast<int>(dice_.even(2.0, 40.0));
  spacing_ = dice_.decades(1e-5, 1e3), gravity_ = dice_.decades(1e-2, 1e3);
  depth_ = spacing_ * dice_.decades(1e-3, 1e2);
  // Froude numbers up to 30.
  speed_ = dice_.chance(0.3) ? 0.0 : std::sqrt(gravity_ * depth_) * dice_.decades(0.1, 30.0);
  made_.scene.grid = fmt::format("{{cells: [{}, {}], spacing: {} m}}", nx_, ny_, spacing_);
  made_.scene.gravity = fmt::format("{} m/s^2", gravity_);
}

void Draw::choose_ground() {
  if (dice_.chance(0.2)) {
    return;
  }
  if (dice_.chance(0.3)) {
    const double slope = dice_.even(0.0, 85.0);
    made_.scene.terrain = fmt::format("{{type: plane, inclination: {} deg, direction: {} deg}}", slope,
                                      ny_ > 1 ? dice_.even(0.0, 360.0) : 0.0);
    height_ = std::tan(slope * 0.0174532925) * spacing_ * (nx_ + ny_);
    return;
  }
  height_ = depth_ * dice_.decades(1e-2, 30.0);
  made_.scene.terrain = fmt::format("{{type: raster, file: {}}}", raster("bed", 0.0, height_, false));
}

void Draw::choose_friction() {
  made_.scene.friction =
      dice_.chance(0.5) ? fmt::format("friction_angle: {{raster: {}, unit: deg}}", raster("friction", 0.0, 89.9, false))
                        : fmt::format("friction_angle: {} deg", dice_.chance(0.2) ? 0.0 : dice_.even(0.0, 89.9));
}

void Draw::choose_hbar() {
  const double kind = dice_.even(0.0, 1.0);
  if (kind < 0.25) {
    made_.scene.hbar = fmt::format("{{policy: truncated, scale: {{raster: {}}}, cap: {{raster: {}, unit: m}}}}",
                                   raster("scale", 1e-3, 1.0, true), raster("cap", 1e-6 * depth_, depth_, true));
  } else if (kind < 0.5) {
    made_.scene.hbar = fmt::format("{{policy: scaled, scale: {{raster: {}}}}}", raster("scale", 1e-6, 1.0, true));
  } else if (kind < 0.75) {
    made_.scene.hbar = fmt::format("{{policy: constant, depth: {} m}}", depth_ * dice_.decades(1e-6, 1.0));
  }
}

/// Dry, thin and deep cells mixed, and two boxes with velocities over them.
void Draw::choose_sand() {
  std::string parts;
  if (dice_.chance(0.5)) {
    parts = fmt::format("{{type: raster, file: {}}}, ", raster("depth", 1e-6 * depth_, depth_, true));
  }
  for (const double edge : {0.0, 0.5}) {
    const double u = speed_ * dice_.even(-1.0, 1.0), v = ny_ > 1 ? speed_ * dice_.even(-1.0, 1.0) : 0.0;
    parts += fmt::format(
        "{{type: box, from: [{0} cells, 0 m], to: [{1} cells, {2} cells], depth: {3} m, velocity: [{4} m/s, {5} "
        "m/s]}}, ",
        edge * nx_, (edge + dice_.even(0.2, 0.6)) * nx_, dice_.even(0.3, 1.0) * ny_, depth_ * dice_.even(0.1, 1.0), u,
        v);
  }
  parts.resize(parts.size() - 2);
  made_.scene.initial = "[" + parts + "]";
  // About three crossings of the grid by its fastest waves or sand.
  made_.scene.end = 3.0 * spacing_ * std::max(nx_, ny_) / (speed_ + std::sqrt(gravity_ * (depth_ + height_)));
}

void Draw::choose_sides() {
  const double kind = dice_.even(0.0, 1.0);
  if (kind < 0.25) {
    made_.scene.boundaries = "{x_min: periodic, x_max: periodic, y_min: periodic, y_max: periodic}";
  } else if (kind < 0.5) {
    made_.scene.boundaries = "{x_min: open, y_max: open}";
  }
}

StressCase Draw::make() && {
  made_.meaning = fmt::format("drawn at random: {} x {} cells of {:.2g} m, sand of {:.2g} m at up to {:.2g} m/s", nx_,
                              ny_, spacing_, depth_, speed_);
  return std::move(made_);
}

}  // namespace

std::vector<StressCase> random_cases(int count) {
  std::vector<StressCase> cases;
  for (int number = 1; number <= count; ++number) {
    cases.push_back(Draw(static_cast<std::uint64_t>(number)).make());
  }
  return cases;
}

}  // namespace sandsim::cli
