// Set-ups and runs for the verification tests: a case is plain data, a run advances it on the CPU backend.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "solver/backend.hpp"

namespace sandsim::test {

/// A grid with its sand, bed and momentum. Momentum arrays may stay empty: the sand is at rest.
struct Case {
  BackendConfig config;
  InitialState initial;
  std::vector<double> momentum_x, momentum_y;  // [m^2/s]

  const Grid& grid() const { return config.grid; }
  std::size_t index(int i, int j = 0) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(grid().cells[0]) + static_cast<std::size_t>(i);
  }
};

/// The schemes that the tests compare. `printed` and `repaired` are the paper's, as printed and with the errata's
/// repairs (hu^2, q/h, rest gate).
enum class Method { order2, order1, repaired, printed };
inline const char* name(Method method) {
  constexpr const char* names[] = {"order 2", "order 1", "paper repaired", "paper printed"};
  return names[static_cast<int>(method)];
}
Numerics numerics_of(Method method, Precision precision = Precision::float64);

/// An empty flat case of nx * ny cells with walls, hbar = h and one friction coefficient.
Case make_case(int nx, int ny, double spacing, double friction, Method method = Method::order2,
               Precision precision = Precision::float64);
void set_method(Case& test, Method method, Precision precision = Precision::float64);

/// Fills depth, bed or momentum at the cell centres.
using Function = std::function<double(double x, double y)>;
std::vector<double> at_centers(const Grid& grid, const Function& function);
/// Fills with the mean over each cell (4 x 4 points, 64 along x in one dimension).
std::vector<double> cell_means(const Grid& grid, const Function& function);

/// A running case. Keeps the largest speed, smallest depth and smallest step over all steps.
class Run {
 public:
  explicit Run(const Case& test);

  /// One step of the stable length, or of `dt`.
  void step();
  void step(double dt);
  /// Steps until `time` is reached exactly. Throws std::runtime_error if a value breaks or steps collapse.
  void until(double time);
  /// Steps until all momentum is exactly zero and nothing changes any more, at most until `limit` [s].
  bool until_rest(double limit);
  /// Steps until all momentum is exactly zero and has been so for 50 steps, at most until `limit` [s]. Depths may still
  /// creep: a face a little steeper than mu levels exponentially slowly, without momentum.
  bool until_still(double limit);
  /// Watches the largest speed after every step; it costs a pass.
  void watch_speed() { watching_ = true; }

  Backend& backend() { return *backend_; }
  const Case& set_up() const { return case_; }
  double time() const { return time_; }
  std::int64_t steps() const { return steps_; }
  double max_speed() const { return max_speed_; }
  double smallest_step() const { return smallest_step_; }

  std::vector<double> depth() const;
  std::vector<double> momentum_x() const;
  std::vector<double> momentum_y() const;

 private:
  Case case_;
  std::unique_ptr<Backend> backend_;
  double time_ = 0.0;
  std::int64_t steps_ = 0;
  double max_speed_ = 0.0;
  double smallest_step_ = std::numeric_limits<double>::infinity();
  bool moving_ = true, changed_ = true;
  bool watching_ = false;
};

/// The state's bits are equal in all three arrays.
bool same_bits(const StateArrays& a, const StateArrays& b);
/// All values as double.
std::vector<double> as_double(const FieldValues& values);
FieldValues in_precision(const std::vector<double>& values, Precision precision);

/// sum |a - b| / sum |b|.
double relative_l1(const std::vector<double>& a, const std::vector<double>& b);
/// Mean over blocks of factor x factor cells (factor x 1 if there is one row).
std::vector<double> coarsen(const Grid& fine, const std::vector<double>& values, int factor);
double sum(const std::vector<double>& values);

/// A reproducible random number in [0, 1): a linear congruential generator, the same on every platform.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 0x9E3779B97F4A7C15ull + 1) {}
  double operator()() {
    state_ = state_ * 6364136223846793005ull + 1442695040888963407ull;
    return static_cast<double>(state_ >> 11) * 0x1p-53;
  }
  double operator()(double low, double high) { return low + (high - low) * (*this)(); }

 private:
  std::uint64_t state_;
};

}  // namespace sandsim::test
