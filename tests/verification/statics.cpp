#include "tests/verification/statics.hpp"

#include <algorithm>
#include <cmath>

namespace sandsim::test {
namespace {

constexpr double pi = 3.14159265358979323846;

double value(const std::vector<double>& map, std::size_t k) {
  return map.size() == 1 ? map[0] : map[k];
}

double minmod(double a, double b) {
  return a * b <= 0.0 ? 0.0 : (std::abs(a) < std::abs(b) ? a : b);
}

/// A few random waves with zero mean; wavelengths between 4 and 32 cells.
Function random_waves(Random& random, double spacing, int count) {
  struct Wave {
    double kx, ky, phase, height;
  };
  std::vector<Wave> waves;
  for (int n = 0; n < count; ++n) {
    const double k = 2.0 * pi / (spacing * random(4.0, 32.0)), direction = random(0.0, 2.0 * pi);
    waves.push_back({k * std::cos(direction), k * std::sin(direction), random(0.0, 2.0 * pi), random(0.2, 1.0)});
  }
  return [=](double x, double y) {
    double sum = 0.0;
    for (const Wave& w : waves) sum += w.height * std::sin(w.kx * x + w.ky * y + w.phase);
    return sum;
  };
}

/// In the run's precision, so that the state is what the run will hold.
void round_to(Precision precision, std::vector<double>& values) {
  if (precision == Precision::float64) return;
  for (double& v : values) v = static_cast<double>(static_cast<float>(v));
}

/// hbar policy number 0 to 3; with maps its numbers vary over the grid.
void choose_material(Case& test, int policy, bool maps, Random& random) {
  const bool scaled = policy == 2 || policy == 3, capped = policy == 1 || policy == 3;
  const std::size_t n = maps ? test.grid().cell_count() : 1;
  test.initial.hbar_scale.assign(n, 1.0);
  test.initial.hbar_cap.assign(n, 1e30);
  test.initial.friction_coefficient.assign(n, 0.0);
  for (std::size_t k = 0; k < n; ++k) {
    if (scaled) test.initial.hbar_scale[k] = random(0.3, 1.0);
    if (capped) test.initial.hbar_cap[k] = random(0.01, 0.1);
    test.initial.friction_coefficient[k] = random(0.4, 0.8);
  }
}

}  // namespace

double steepness(const Case& test) {
  const Grid& grid = test.grid();
  const InitialState& state = test.initial;
  const int nx = grid.cells[0], ny = grid.cells[1];
  const auto bed = [&](std::size_t k) { return state.bed.empty() ? 0.0 : state.bed[k]; };
  double worst = 0.0;
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) {
      const std::size_t k = test.index(i, j);
      if (state.depth[k] <= 0.0) continue;
      const double mu = value(state.friction_coefficient, k), surface = bed(k) + state.depth[k];
      // A wall mirrors; a neighbour whose bed stands above this surface cannot push and carries no sand.
      const auto difference = [&](int ni, int nj, bool& blocked) {
        const std::size_t n = test.index(std::clamp(ni, 0, nx - 1), std::clamp(nj, 0, ny - 1));
        const double ds = bed(n) + state.depth[n] - surface;
        blocked = bed(n) >= surface && ds > 0.0;
        const double holds = std::min(mu, value(state.friction_coefficient, n));
        if (!blocked) worst = std::max(worst, std::abs(ds) / (holds * grid.spacing));
        return ds;
      };
      double squared = 0.0;
      for (const bool along_x : {true, false}) {
        bool low_blocked = false, high_blocked = false;
        const double low = -difference(along_x ? i - 1 : i, along_x ? j : j - 1, low_blocked);
        const double high = difference(along_x ? i + 1 : i, along_x ? j : j + 1, high_blocked);
        const double low_seen = low_blocked ? minmod(low, high) : low;
        const double high_seen = high_blocked ? minmod(high, low) : high;
        squared += std::pow(0.5 * (low_seen + high_seen) / grid.spacing, 2);
      }
      worst = std::max(worst, std::sqrt(squared) / mu);
    }
  }
  return worst;
}

Case rough_pile(std::uint64_t seed, Method method, Precision precision) {
  Random random(seed);
  const double spacing = 0.01;
  Case test = make_case(40, 36, spacing, 0.5, method, precision);
  choose_material(test, static_cast<int>(seed % 4), seed % 8 >= 4, random);
  const Function hills = random_waves(random, spacing, 6), waves = random_waves(random, spacing, 4);
  const double roughness = random(0.002, 0.02);
  // Cells of the ground stand up to two spacings above each other: steps, pits and spikes.
  test.initial.bed =
      at_centers(test.grid(), [&](double x, double y) { return 0.02 * hills(x, y) + random(-roughness, roughness); });
  round_to(precision, test.initial.bed);
  double amplitude = 0.05;
  for (int attempt = 0; attempt < 60; ++attempt) {
    test.initial.depth = at_centers(test.grid(), [&](double x, double y) { return 0.01 + amplitude * waves(x, y); });
    for (std::size_t k = 0; k < test.initial.depth.size(); ++k) {
      test.initial.depth[k] = std::max(0.0, test.initial.depth[k] - test.initial.bed[k]);
    }
    round_to(precision, test.initial.depth);
    const double worst = steepness(test);
    if (worst <= 0.999 && worst > 0.99) break;
    amplitude *= worst > 0.999 ? 0.9985 / worst : 0.5 * (1.0 + 0.9985 / worst);
  }
  return test;
}

Case lake(std::uint64_t seed, Method method, Precision precision) {
  Random random(seed + 1000);
  Case test = make_case(40, 36, 0.02, 0.0, method, precision);
  choose_material(test, static_cast<int>(seed % 4), seed % 8 >= 4, random);
  test.initial.friction_coefficient = {0.0};
  const Function hills = random_waves(random, 0.02, 6);
  const double level = 0.125;  // a number that float32 holds exactly
  test.initial.bed = at_centers(test.grid(), [&](double x, double y) { return 0.1 * hills(x, y) + random(0.0, 0.1); });
  round_to(precision, test.initial.bed);
  std::transform(test.initial.bed.begin(), test.initial.bed.end(), test.initial.depth.begin(),
                 [&](double bed) { return std::max(0.0, level - bed); });
  round_to(precision, test.initial.depth);
  return test;
}

Case cone(double angle, double part, Method method, Precision precision) {
  const double mu = std::tan(angle / 180.0 * pi), spacing = 0.02;
  Case test = make_case(48, 48, spacing, mu, method, precision);
  const double middle = 24.0 * spacing, height = part * mu * 18.0 * spacing;
  test.initial.depth = at_centers(test.grid(), [&](double x, double y) {
    return std::max(0.0, height - part * mu * std::hypot(x - middle, y - middle));
  });
  return test;
}

}  // namespace sandsim::test
