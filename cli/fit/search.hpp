// The search for the best fit, for what fits equally well, and the map of the misfit around it.
#pragma once

#include <optional>
#include <vector>

#include "cli/fit/evaluator.hpp"

namespace sandsim::cli {

struct SearchSettings {
  int evaluations = 100;  // of the search, its start included
  int parallel = 1;
  int map = 11;  // points along each side of the map; 0: none
  std::uint64_t seed = 1;
  double tolerance = 0.0;  // [m] how well the data, or the grid, are known
};

/// The values of one parameter that fit equally well while the others are chosen as suits it best.
struct FitRange {
  FitPoint low, high;  // points at its two ends, which fit
};

/// Where the map lies: fractions of the first parameter, and of the second if there is one.
struct MapWindow {
  double from = 0.0, to = 1.0;
};

struct FitResult {
  Evaluation best;
  double limit = 0.0;                 // [m] what misfit counts as equally good
  std::vector<FitRange> ranges;       // one a parameter
  std::vector<MapWindow> windows;     // one or two; empty without a map
  std::vector<Evaluation> map;        // first parameter fastest; further parameters are those of the best
  std::vector<Evaluation> evaluated;  // all
};

/// Number of points of a Latin hypercube that the search starts from.
int start_points(std::size_t parameters, int evaluations);

/// Starts from a Latin hypercube, goes down from its best two points with NLopt, finds the ranges by following each
/// parameter away from the best point while the others are fitted again, and draws the map. The result does not depend
/// on `parallel`. Throws Error with exit code 5 if all runs of the start fail, and what an evaluation throws.
class FitSearch {
 public:
  FitSearch(Evaluator& evaluator, const SearchSettings& settings);

  void start();
  /// Mean time of a run of the start. [s]
  double seconds_per_run() const { return seconds_; }
  FitResult finish();

 private:
  /// Goes down from `start` along the parameters `free`, `step` at first, until the misfit is at most `enough`.
  Evaluation descend(const FitPoint& start, const std::vector<std::size_t>& free, double step, int budget,
                     double enough, Origin& origin);
  void descend_from_starts();
  void find_ranges();
  void widen_ranges();
  FitPoint find_end(std::size_t parameter, double direction, Origin origin);
  Evaluation fit_others(const FitPoint& guess, std::size_t parameter, Origin& origin);
  void draw_map();
  void take_best();
  double objective(const Evaluation& evaluation) const;

  Evaluator& evaluator_;
  SearchSettings settings_;
  std::size_t count_;  // of parameters
  std::vector<Evaluation> starts_;
  double seconds_ = 0.0;
  double penalty_ = 0.0;  // [m] misfit that stands for that of a run that failed
  std::size_t next_task_ = 0;
  FitResult result_;
};

}  // namespace sandsim::cli
