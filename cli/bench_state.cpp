#include "cli/bench_state.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "solver/numerics.hpp"

namespace sandsim::cli {

namespace {

constexpr double spacing = 0.01;  // [m] as in the paper's flume

/// sin(2 pi waves k/size) for every k: whole waves fit a periodic grid.
std::vector<double> wave(int size, int waves) {
  std::vector<double> values(static_cast<std::size_t>(size));
  for (std::size_t k = 0; k < values.size(); ++k) {
    values[k] = std::sin(2.0 * std::numbers::pi * waves * static_cast<double>(k) / size);
  }
  return values;
}

/// Waves of several lengths in both directions, between -1 and 1.
class Waves {
 public:
  explicit Waves(int size) : long_(wave(size, 3)), middle_(wave(size, 17)), short_(wave(size, size / 16)) {}

  double at(std::size_t i, std::size_t j) const {
    return 0.5 * long_[i] * long_[j] + 0.3 * middle_[i] * middle_[j] + 0.2 * short_[i] * short_[j];
  }

 private:
  std::vector<double> long_, middle_, short_;
};

template <class Real>
StateArrays moving_state(int size) {
  const auto side = static_cast<std::size_t>(size);
  const Waves waves(size);
  std::vector<Real> depth(side * side), momentum_x(side * side), momentum_y(side * side);
#pragma omp parallel for schedule(static)
  for (std::size_t j = 0; j < side; ++j) {
    for (std::size_t i = 0; i < side; ++i) {
      const double ripple = waves.at(i, j);
      const double turned = waves.at(side - 1 - j, i);
      const double h = 0.2 + 0.06 * ripple;
      depth[j * side + i] = static_cast<Real>(h);
      momentum_x[j * side + i] = static_cast<Real>(h * (3.0 + 0.5 * turned));
      momentum_y[j * side + i] = static_cast<Real>(h * (1.0 - 0.5 * turned));
    }
  }
  return {std::move(depth), std::move(momentum_x), std::move(momentum_y)};
}

}  // namespace

std::vector<StepCase> step_cases(Precision precision) {
  std::vector<StepCase> cases;
  for (const bool terrain : {false, true}) {
    cases.push_back({Scheme::paper, 1, precision, terrain});
    cases.push_back({Scheme::balanced, 1, precision, terrain});
    cases.push_back({Scheme::balanced, 2, precision, terrain});
  }
  return cases;
}

std::string scheme_name(const StepCase& which) {
  return which.scheme == Scheme::paper ? "paper" : fmt::format("balanced order {}", which.order);
}

const char* precision_name(Precision precision) {
  return precision == Precision::float32 ? "float32" : "float64";
}

double floor_bytes(const StepCase& which) {
  const double word = which.precision == Precision::float32 ? 4.0 : 8.0;
  return word * (which.terrain ? 8.0 : 7.0);
}

BackendConfig bench_config(const StepCase& which, int size, int threads) {
  BackendConfig config;
  config.grid.cells = {size, size};
  config.grid.spacing = spacing;
  config.boundaries = {BoundaryKind::periodic, BoundaryKind::periodic, BoundaryKind::periodic, BoundaryKind::periodic};
  config.numerics.scheme = which.scheme;
  config.numerics.order = which.order;
  config.numerics.precision = which.precision;
  config.courant = default_courant(config.numerics);
  config.threads = threads;
  return config;
}

InitialState bench_initial(const StepCase& which, int size) {
  const auto side = static_cast<std::size_t>(size);
  InitialState initial;
  initial.depth.assign(side * side, 0.2);
  initial.friction_coefficient = {0.5985};  // Section 7.1 of the paper, as is hbar = min(0.8 h, 5 cm).
  initial.hbar_scale = {0.8};
  initial.hbar_cap = {0.05};
  if (which.terrain) {
    const Waves waves(size);
    initial.bed.resize(side * side);
#pragma omp parallel for schedule(static)
    for (std::size_t j = 0; j < side; ++j) {
      for (std::size_t i = 0; i < side; ++i) {
        initial.bed[j * side + i] = 0.05 * waves.at(j, i);
      }
    }
  }
  return initial;
}

StateArrays moving_state(Precision precision, int size) {
  return precision == Precision::float32 ? moving_state<float>(size) : moving_state<double>(size);
}

double bench_host_bytes(Precision precision, int size) {
  const double word = precision == Precision::float32 ? 4.0 : 8.0;
  // Depth and bed in double precision; the state to start from; a backend's two states, bed and work arrays.
  return (2.0 * 8.0 + 3.0 * word + 10.0 * word) * size * size;
}

}  // namespace sandsim::cli
