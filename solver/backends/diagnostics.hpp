// What is asked of a state between steps: fields for output, sums, probes, maxima, broken cells, slopes.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "solver/backend.hpp"
#include "solver/backends/cell_values.hpp"
#include "solver/backends/sums.hpp"
#include "solver/field.hpp"
#include "solver/physics/surface.hpp"

namespace sandsim {

/// A state and what surrounds it.
template <class R>
struct Diagnosed {
  int nx, ny;
  double spacing;  // [m] the scene's, for sums in float64
  physics::StepParameters<R> parameters;
  FieldView<R> h, hu, hv, bed, mu;
  physics::Material<R> material;
  Cover<R> cover;
  bool flat, uniform;

  R velocity(R momentum, R depth) const { return physics::quotient_velocity(momentum, depth, parameters.dry_depth); }
  R b(int i, int j) const { return flat ? R(0) : bed.row(j)[i]; }
  R friction(int i, int j) const { return uniform ? material.mu : mu.row(j)[i]; }
};

/// value(i, j) of every cell, x fastest.
template <class R, class Value>
std::vector<R> gather(const Diagnosed<R>& d, Value value) {
  std::vector<R> out(static_cast<std::size_t>(d.nx) * static_cast<std::size_t>(d.ny));
  auto next = out.begin();
  for (int j = 0; j < d.ny; ++j) {
    for (int i = 0; i < d.nx; ++i) {
      *next++ = value(i, j);
    }
  }
  return out;
}

/// Throws std::invalid_argument.
CellField cell_field(const std::string& name);

template <class R>
FieldValues named_field(const Diagnosed<R>& d, const std::string& name) {
  const CellField field = cell_field(name);
  const R dry = d.parameters.dry_depth;
  return gather(d, [&](int i, int j) {
    return cell_value(field, d.cover, i, j, d.h.row(j)[i], d.hu.row(j)[i], d.hv.row(j)[i], d.b(i, j), dry);
  });
}

/// All that a run needs to go on from this state.
template <class R>
StateArrays state_of(const Diagnosed<R>& d) {
  StateArrays state{
      named_field(d, "flowing_depth"), named_field(d, "momentum_x"), named_field(d, "momentum_y"), {}, {}};
  if (!d.cover.none()) {
    state.bed = named_field(d, "flow_bed");
    std::vector<double> buried;
    for (int j = 0; j < d.ny; ++j) {
      buried.insert(buried.end(), d.cover.buried.row(j), d.cover.buried.row(j) + d.nx);
    }
    state.buried = std::move(buried);
  }
  return state;
}

template <class R>
ProbeSample probe(const Diagnosed<R>& d, int i, int j) {
  const R h = d.h.row(j)[i];
  return {static_cast<double>(d.cover.depth(i, j, h)), static_cast<double>(d.velocity(d.hu.row(j)[i], h)),
          static_cast<double>(d.velocity(d.hv.row(j)[i], h))};
}

inline GridStatistics grid_statistics(const CellSums& sums, double spacing) {
  const double area = spacing * spacing;
  return {sums.depth * area, sums.energy * area, sums.max_speed,
          sums.moving_cells, sums.max_depth,     sums.max_speed_above};
}

/// Rows are summed side by side, and then the rows. Speeds of sand deeper than `above` [m] count for max_speed_above.
template <class R>
GridStatistics grid_statistics(const Diagnosed<R>& d, double above, int threads) {
  const R threshold = static_cast<R>(above);
  std::vector<CellSums> rows(static_cast<std::size_t>(d.ny));
#pragma omp parallel for num_threads(threads) schedule(static) if (threads > 1)
  for (int j = 0; j < d.ny; ++j) {
    const R *h = d.h.row(j), *hu = d.hu.row(j), *hv = d.hv.row(j);
    rows[static_cast<std::size_t>(j)] =
        sum_in_lanes<CellSums>(static_cast<std::size_t>(d.nx), [&](CellSums& lane, std::size_t i) {
          lane.add_cell(h[i], hu[i], hv[i], d.cover.buried_at(static_cast<int>(i), j), threshold);
        });
  }
  return grid_statistics(sum_in_lanes<CellSums>(rows.size(), [&](CellSums& lane, std::size_t j) { lane += rows[j]; }),
                         d.spacing);
}

template <class R>
Incident first_broken(const Diagnosed<R>& d) {
  for (int j = 0; j < d.ny; ++j) {
    for (int i = 0; i < d.nx; ++i) {
      const R h = d.h.row(j)[i];
      const bool finite = std::isfinite(h) && std::isfinite(d.hu.row(j)[i]) && std::isfinite(d.hv.row(j)[i]);
      if (!finite || h < R(0)) {
        Incident incident;
        incident.i = i, incident.j = j;
        incident.cause = finite ? "negative depth" : "a value that is not finite";
        return incident;
      }
    }
  }
  return {};
}

/// Largest |ds|/(mu dx) - 1 over faces between wet cells, |ds| as friction sees it; 0 if no face is steeper than its
/// mu, or mu is 0.
template <class R>
double largest_slope_violation(const Diagnosed<R>& d) {
  double largest = 0.0;
  const auto face = [&](int i, int j, int ie, int je) {
    const R h_left = d.h.row(j)[i], h_right = d.h.row(je)[ie];
    const R mu = std::min(d.friction(i, j), d.friction(ie, je));
    if (h_left > d.parameters.dry_depth && h_right > d.parameters.dry_depth && mu > R(0)) {
      const R b_left = d.b(i, j), b_right = d.b(ie, je);
      const R jump = physics::surface_difference(h_left, h_right, b_left, b_right);
      const R drop = physics::surface_drop(jump, h_left, h_right, b_left, b_right);
      const double ratio = static_cast<double>(drop) / (static_cast<double>(mu) * static_cast<double>(d.parameters.dx));
      largest = std::max(largest, ratio - 1.0);
    }
  };
  for (int j = 0; j < d.ny; ++j) {
    for (int i = 0; i < d.nx; ++i) {
      if (i + 1 < d.nx) {
        face(i, j, i + 1, j);
      }
      if (j + 1 < d.ny) {
        face(i, j, i, j + 1);
      }
    }
  }
  return largest;
}

/// max_depth, max_speed and arrival_time of every cell.
template <class R>
class Maxima {
 public:
  Maxima() = default;
  Maxima(std::size_t cells, R above, R drained)
      : above_(above),
        drained_(drained),
        depth_(cells, R(0)),
        speed_(cells, R(0)),
        arrival_(cells, std::numeric_limits<R>::quiet_NaN()) {}

  void update(const Diagnosed<R>& d, double time, int threads) {
    const R now = static_cast<R>(time);
#pragma omp parallel for num_threads(threads) schedule(static) if (threads > 1)
    for (int j = 0; j < d.ny; ++j) {
      const std::size_t first = static_cast<std::size_t>(j) * static_cast<std::size_t>(d.nx);
      R *depth = depth_.data() + first, *speed = speed_.data() + first, *arrival = arrival_.data() + first;
      const R *h = d.h.row(j), *hu = d.hu.row(j), *hv = d.hv.row(j);
      for (int i = 0; i < d.nx; ++i) {
        take_maxima(d.cover.depth(i, j, h[i]), h[i], hu[i], hv[i], now, above_, drained_, d.parameters.dry_depth,
                    depth[i], speed[i], arrival[i]);
      }
    }
  }
  FinalFields fields() const {
    return {depth_, speed_, arrival_};
  }
  void set(const FinalFields& fields) {
    depth_ = std::get<std::vector<R>>(fields.max_depth);
    speed_ = std::get<std::vector<R>>(fields.max_speed);
    arrival_ = std::get<std::vector<R>>(fields.arrival_time);
  }
  std::size_t bytes() const {
    return (depth_.size() + speed_.size() + arrival_.size()) * sizeof(R);
  }

 private:
  R above_ = 0;    // [m]
  R drained_ = 0;  // [-]
  std::vector<R> depth_, speed_, arrival_;
};

}  // namespace sandsim
