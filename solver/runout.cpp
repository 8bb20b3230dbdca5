#include "solver/runout.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "solver/backend_config.hpp"
#include "solver/snapshot.hpp"

namespace sandsim {
namespace {

/// Default of the threshold, of the largest depth at the start. The last thousandths of a tail slide on by themselves,
/// faster than the sand that has left them behind; a hundredth is what outlines of deposits are usually drawn at.
constexpr double thin_fraction = 0.01;
/// The same of the spacing, where nothing is known of how deep the sand will be.
constexpr double thin_fraction_of_spacing = 0.01;
/// Share of the sand that may have left the grid while what the rest did is taken for what all of it did.
constexpr double most_left = 0.01;
/// Of the spacing: the centre of mass of a deposit that is symmetric but for rounding does not move.
constexpr double least_shift = 1e-3;

bool much_has_left(const Ledger& ledger) {
  return ledger.out > most_left * (ledger.initial + ledger.in);
}

double rounded(double value, bool is_single) {
  return is_single ? static_cast<double>(static_cast<float>(value)) : value;
}

}  // namespace

double thin_depth(const Scene& scene, const InitialState& initial) {
  if (scene.output.maxima && scene.output.maxima->above) {
    return *scene.output.maxima->above;
  }
  const double largest = *std::max_element(initial.depth.begin(), initial.depth.end());
  return largest > 0.0 ? thin_fraction * largest : thin_fraction_of_spacing * scene.grid.spacing;
}

RunoutMeter::RunoutMeter(const Scene& scene, const InitialState& initial)
    : scene_(scene),
      initial_(initial),
      is_single_(scene.numerics.precision == Precision::float32),
      above_(thin_depth(scene, initial)),
      threshold_(rounded(above_, is_single_)) {
  find_top();
}

double RunoutMeter::initial_depth(std::size_t cell) const {
  return rounded(initial_.depth[cell], is_single_);
}

RunoutMeter::Place RunoutMeter::ground(std::size_t cell) const {
  const auto nx = static_cast<std::size_t>(scene_.grid.cells[0]);
  return {scene_.grid.x(static_cast<int>(cell % nx)), scene_.grid.y(static_cast<int>(cell / nx)),
          initial_.bed.empty() ? 0.0 : initial_.bed[cell]};
}

void RunoutMeter::find_top() {
  std::vector<std::size_t> release;
  for (std::size_t cell = 0; cell < initial_.depth.size(); ++cell) {
    if (initial_depth(cell) > threshold_) {
      release.push_back(cell);
    }
  }
  for (const SandRain& rain : sand_rains(scene_)) {
    release.insert(release.end(), rain.cells.begin(), rain.cells.end());
  }
  double highest = -HUGE_VAL;
  const auto surface = [&](std::size_t cell) { return ground(cell).z + initial_depth(cell); };
  for (const std::size_t cell : release) {
    highest = std::max(highest, surface(cell));
  }
  double x = 0.0, y = 0.0, count = 0.0;
  for (const std::size_t cell : release) {
    if (surface(cell) >= highest - above_) {
      const Place place = ground(cell);
      x += place.x, y += place.y, count += 1.0;
    }
  }
  if (count > 0.0) {
    top_ = Place{x / count, y / count, highest};
  }
}

void RunoutMeter::take(const FieldValues& depth, double max_depth, double max_speed) {
  std::visit(
      [&]<class R>(const std::vector<R>& values) {
        const R threshold = static_cast<R>(threshold_);
        record_.reached.resize(values.size());
        for (std::size_t cell = 0; cell < values.size(); ++cell) {
          record_.reached[cell] |= static_cast<std::uint8_t>(values[cell] > threshold);
        }
      },
      depth);
  record_.max_depth = std::max(record_.max_depth, max_depth);
  record_.max_speed = std::max(record_.max_speed, max_speed);
}

/// Calls visit(place on the ground) for the centre of a cell that is deeper than the threshold, and for the points
/// towards its shallower neighbours at which the depth, taken as linear, falls to it.
template <class Visit>
void RunoutMeter::visit_outline(std::size_t cell, const std::vector<double>& depth, Visit visit) const {
  if (!(depth[cell] > threshold_)) {
    return;
  }
  const auto nx = static_cast<std::size_t>(scene_.grid.cells[0]), ny = static_cast<std::size_t>(scene_.grid.cells[1]);
  const std::size_t i = cell % nx, j = cell / nx;
  const Place here = ground(cell);
  visit(here);
  const auto visit_towards = [&](bool exists, std::size_t other) {
    if (exists && !(depth[other] > threshold_)) {
      const double part = (depth[cell] - threshold_) / (depth[cell] - depth[other]);
      const Place there = ground(other);
      visit(Place{here.x + part * (there.x - here.x), here.y + part * (there.y - here.y),
                  here.z + part * (there.z - here.z)});
    }
  };
  visit_towards(i > 0, cell - 1);
  visit_towards(i + 1 < nx, cell + 1);
  visit_towards(j > 0, cell - nx);
  visit_towards(j + 1 < ny, cell + nx);
}

/// Area, deposit, and the farthest ground that was bare at the start and bears sand now; where sand has left the grid,
/// that has borne some: then it is near the edge.
void RunoutMeter::add_ground(RunoutReport& report, const std::vector<double>& depth, bool has_left) const {
  if (top_) {
    report.front = {0.0, 0.0};
  }
  const auto take_farthest = [&](const Place& place) {
    const double distance = top_ ? std::hypot(place.x - top_->x, place.y - top_->y) : 0.0;
    if (distance > report.front.distance) {
      report.front = {distance, top_->z - place.z};
    }
  };
  double cells = 0.0;
  for (std::size_t cell = 0; cell < depth.size(); ++cell) {
    const bool was_reached = !record_.reached.empty() && record_.reached[cell] != 0;
    if (!was_reached && !(depth[cell] > threshold_)) {
      continue;
    }
    cells += 1.0;
    const bool is_new = !(initial_depth(cell) > threshold_);
    if (is_new && has_left) {
      take_farthest(ground(cell));
    }
    visit_outline(cell, depth, [&](const Place& place) {
      report.deposit_front = std::fmax(report.deposit_front, place.x);
      if (is_new) {
        take_farthest(place);
      }
    });
  }
  report.area = cells * scene_.grid.spacing * scene_.grid.spacing;
}

template <class Depth>
RunoutMeter::Place RunoutMeter::center_of_mass(Depth depth) const {
  double sum = 0.0, x = 0.0, y = 0.0, z = 0.0;
  for (std::size_t cell = 0; cell < initial_.depth.size(); ++cell) {
    if (const double here = depth(cell); here > 0.0) {
      const Place place = ground(cell);
      sum += here, x += here * place.x, y += here * place.y, z += here * (place.z + 0.5 * here);
    }
  }
  return {x / sum, y / sum, z / sum};
}

Descent RunoutMeter::descent_of_mass(const std::vector<double>& depth, const Ledger& ledger) const {
  if (ledger.in > 0.0 || much_has_left(ledger)) {
    return {};
  }
  const Place from = center_of_mass([&](std::size_t cell) { return initial_depth(cell); });
  const Place to = center_of_mass([&](std::size_t cell) { return depth[cell]; });
  const double distance = std::hypot(to.x - from.x, to.y - from.y);
  return {distance > least_shift * scene_.grid.spacing ? distance : 0.0, from.z - to.z};
}

RunoutReport RunoutMeter::report(const FieldValues& last_depth, const Ledger& ledger) const {
  const std::vector<double> depth = as_double(last_depth);
  RunoutReport report;
  report.above = above_;
  add_ground(report, depth, much_has_left(ledger));
  report.center_of_mass = descent_of_mass(depth, ledger);
  report.deposit_height = *std::max_element(depth.begin(), depth.end());
  report.max_depth = std::max(record_.max_depth, report.deposit_height);
  report.max_speed = record_.max_speed;
  return report;
}

}  // namespace sandsim
