// Follows how far the sand of a run goes: travel angles, affected area, largest depth and speed.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "solver/initial_state.hpp"
#include "solver/report.hpp"
#include "solver/scene.hpp"
#include "solver/sink.hpp"

namespace sandsim {

/// The depth above which sand counts: output.maxima.above, else 1 % of the largest depth at the start, or 1 % of the
/// spacing where no sand is there at the start. [m]
double thin_depth(const Scene& scene, const InitialState& initial);

/// Without output.maxima.above, the speed of what is left in a cell below this share of its largest depth does not
/// count for the map of the largest speed. [-] Sand that drains from a cell of length dx with acceleration a, du/dt = a
/// and dh/dt = -u h/dx, leaves h = h_0 exp(-(u^2 - u_0^2)/(2 a dx)) at the speed u: below 1/e of h_0 it is faster than
/// a fall over the whole cell could make it.
inline constexpr double drained_share = 0.36787944117144233;

/// What has been seen so far; a checkpoint keeps it.
struct RunoutRecord {
  std::vector<std::uint8_t>
      reached;             // 1 in cells that held sand deeper than the threshold; empty before the first take
  double max_depth = 0.0;  // [m]
  double max_speed = 0.0;  // [m/s] of such sand
};

/// Both that it is made from must outlive it.
class RunoutMeter {
 public:
  RunoutMeter(const Scene& scene, const InitialState& initial);

  double above() const { return above_; }
  /// Takes in the depths of a frame, or the largest ones of the run, and the largest depth and speed among them.
  void take(const FieldValues& depth, double max_depth, double max_speed);
  const RunoutRecord& record() const { return record_; }
  void set_record(RunoutRecord record) { record_ = std::move(record); }
  /// At the end of a run, with its last depths.
  RunoutReport report(const FieldValues& depth, const Ledger& ledger) const;

 private:
  struct Place {
    double x, y, z;  // [m]
  };

  void find_top();
  double initial_depth(std::size_t cell) const;
  Place ground(std::size_t cell) const;
  template <class Visit>
  void visit_outline(std::size_t cell, const std::vector<double>& depth, Visit visit) const;
  void add_ground(RunoutReport& report, const std::vector<double>& depth, bool has_left) const;
  template <class Depth>
  Place center_of_mass(Depth depth) const;
  Descent descent_of_mass(const std::vector<double>& depth, const Ledger& ledger) const;

  const Scene& scene_;
  const InitialState& initial_;
  bool is_single_;            // precision, which depths are rounded to
  double above_;              // [m]
  double threshold_;          // [m] rounded likewise
  std::optional<Place> top_;  // of the release; none if there is no sand, and no source
  RunoutRecord record_;
};

}  // namespace sandsim
