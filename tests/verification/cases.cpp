#include "tests/verification/cases.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <stdexcept>

#include "solver/numerics.hpp"

namespace sandsim::test {

Numerics numerics_of(Method method, Precision precision) {
  Numerics numerics;
  numerics.precision = precision;
  numerics.scheme = method == Method::order2 || method == Method::order1 ? Scheme::balanced : Scheme::paper;
  numerics.order = method == Method::order1 ? 1 : 2;
  const bool repaired = method == Method::repaired;
  numerics.momentum_flux = repaired ? MomentumFlux::full : MomentumFlux::printed;
  numerics.velocity = repaired ? VelocityForm::quotient : VelocityForm::desingularised;
  numerics.rest_gate = repaired;
  return numerics;
}

void set_method(Case& test, Method method, Precision precision) {
  test.config.numerics = numerics_of(method, precision);
  test.config.courant = default_courant(test.config.numerics);
}

Case make_case(int nx, int ny, double spacing, double friction, Method method, Precision precision) {
  Case test;
  test.config.grid.cells = {nx, ny};
  test.config.grid.spacing = spacing;
  // One thread: the runs are small, and ctest may run several at once. Another test shows that it does not matter.
  test.config.threads = 1;
  set_method(test, method, precision);
  test.initial.depth.assign(test.grid().cell_count(), 0.0);
  test.initial.friction_coefficient = {friction};
  test.initial.hbar_scale = {1.0};
  test.initial.hbar_cap = {1e30};
  return test;
}

std::vector<double> at_centers(const Grid& grid, const Function& function) {
  std::vector<double> values;
  values.reserve(grid.cell_count());
  for (int j = 0; j < grid.cells[1]; ++j) {
    for (int i = 0; i < grid.cells[0]; ++i) values.push_back(function(grid.x(i), grid.y(j)));
  }
  return values;
}

std::vector<double> cell_means(const Grid& grid, const Function& function) {
  const int columns = grid.one_dimensional() ? 64 : 4, rows = grid.one_dimensional() ? 1 : 4;
  const auto mean = [&](double x, double y) {
    double total = 0.0;
    for (int b = 0; b < rows; ++b) {
      for (int a = 0; a < columns; ++a) {
        total += function(x + ((a + 0.5) / columns - 0.5) * grid.spacing, y + ((b + 0.5) / rows - 0.5) * grid.spacing);
      }
    }
    return total / (columns * rows);
  };
  return at_centers(grid, mean);
}

Run::Run(const Case& test) : case_(test), backend_(make_cpu_backend(test.config, test.initial)) {
  if (test.momentum_x.empty() && test.momentum_y.empty()) return;
  const Precision precision = test.config.numerics.precision;
  const std::vector<double> none(test.grid().cell_count(), 0.0);
  StateArrays state = backend_->state();
  state.momentum_x = in_precision(test.momentum_x.empty() ? none : test.momentum_x, precision);
  state.momentum_y = in_precision(test.momentum_y.empty() ? none : test.momentum_y, precision);
  backend_->set_state(state);
}

void Run::step() {
  step(backend_->stable_step());
}

void Run::step(double dt) {
  const StepOutcome outcome = backend_->step(dt);
  if (outcome.broken) throw std::runtime_error("a value broke: " + backend_->find_broken().cause);
  moving_ = outcome.moving;
  changed_ = outcome.changed;
  smallest_step_ = std::min(smallest_step_, dt);
  time_ += dt;
  ++steps_;
  if (watching_) max_speed_ = std::max(max_speed_, backend_->statistics().max_speed);
}

void Run::until(double time) {
  while (time_ < time) {
    const double stable = backend_->stable_step(), left = time - time_;
    // A sliver at the end would not be wrong, but two halves cost the same and keep the steps even.
    const double dt = stable >= left ? left : (stable > 0.5 * left ? 0.5 * left : stable);
    if (dt < 1e-9 * time) throw std::runtime_error("the steps collapse");
    step(dt);
    if (stable >= left) time_ = time;
  }
}

bool Run::until_rest(double limit) {
  while (time_ < limit) {
    const double dt = std::min(backend_->stable_step(), limit - time_);
    step(dt);
    if (!moving_ && !changed_) return true;
  }
  return false;
}

bool Run::until_still(double limit) {
  for (int still = 0; still < 50;) {
    if (time_ >= limit) return false;
    step(std::min(backend_->stable_step(), limit - time_));
    still = moving_ ? 0 : still + 1;
  }
  return true;
}

std::vector<double> Run::depth() const {
  return as_double(backend_->state().depth);
}
std::vector<double> Run::momentum_x() const {
  return as_double(backend_->state().momentum_x);
}
std::vector<double> Run::momentum_y() const {
  return as_double(backend_->state().momentum_y);
}

namespace {
bool same_bits(const FieldValues& a, const FieldValues& b) {
  const auto equal = [&](const auto& left) {
    const auto& right = std::get<std::decay_t<decltype(left)>>(b);
    return left.size() == right.size() &&
           std::memcmp(left.data(), right.data(), left.size() * sizeof(left.front())) == 0;
  };
  return a.index() == b.index() && std::visit(equal, a);
}
}  // namespace

bool same_bits(const StateArrays& a, const StateArrays& b) {
  return same_bits(a.depth, b.depth) && same_bits(a.momentum_x, b.momentum_x) && same_bits(a.momentum_y, b.momentum_y);
}

std::vector<double> as_double(const FieldValues& values) {
  const auto convert = [](const auto& in) { return std::vector<double>(in.begin(), in.end()); };
  return std::visit(convert, values);
}

FieldValues in_precision(const std::vector<double>& values, Precision precision) {
  if (precision == Precision::float64) return values;
  std::vector<float> narrow(values.size());
  std::transform(values.begin(), values.end(), narrow.begin(), [](double v) { return static_cast<float>(v); });
  return narrow;
}

double relative_l1(const std::vector<double>& a, const std::vector<double>& b) {
  double difference = 0.0, size = 0.0;
  for (std::size_t k = 0; k < b.size(); ++k) {
    difference += std::abs(a[k] - b[k]);
    size += std::abs(b[k]);
  }
  return difference / size;
}

std::vector<double> coarsen(const Grid& fine, const std::vector<double>& values, int factor) {
  const int nx = fine.cells[0] / factor, height = fine.one_dimensional() ? 1 : factor;
  const int ny = fine.cells[1] / height;
  std::vector<double> coarse(static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny), 0.0);
  for (int j = 0; j < ny * height; ++j) {
    for (int i = 0; i < nx * factor; ++i) {
      const auto from = static_cast<std::size_t>(j) * static_cast<std::size_t>(fine.cells[0]);
      const auto to = static_cast<std::size_t>(j / height) * static_cast<std::size_t>(nx);
      coarse[to + static_cast<std::size_t>(i / factor)] +=
          values[from + static_cast<std::size_t>(i)] / (factor * height);
    }
  }
  return coarse;
}

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

}  // namespace sandsim::test
