#include "cli/fit/search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <functional>
#include <limits>
#include <nlopt.hpp>
#include <numeric>
#include <stdexcept>

#include "solver/errors.hpp"

namespace sandsim::cli {

namespace {

using Stage = Origin::Stage;

// Fractions of the way between the bounds:
constexpr double first_step = 0.15;         // of a descent, about half the distance of two points of the start
constexpr double settled = 1e-5;            // steps so small end a descent
constexpr double far_apart = 0.25;          // distance of two starts that are worth a descent each
constexpr double nearest_look = 1.0 / 256;  // first step along a range; then twice as far each time
constexpr double widest_map = 2.5;          // the map reaches so many times as far as the range
constexpr double smallest_map = 0.05;       // but at least so far
constexpr int bisections = 4;               // of the last step along a range: 1/16 of it
constexpr int runs_a_look = 12;             // along a range, for each of the other parameters
constexpr int most_rounds = 3;              // if a range leads to something better, the search starts again from it

using Objective = std::function<double(const std::vector<double>&)>;

bool is_better(const Evaluation& a, const Evaluation& b) {
  return !a.failed() && (b.failed() || a.misfit < b.misfit);
}

double distance(const FitPoint& a, const FitPoint& b) {
  double largest = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    largest = std::max(largest, std::abs(a[k] - b[k]));
  }
  return largest;
}

/// NLopt's BOBYQA (Powell 2009) models the squared misfit by a quadratic, but needs two parameters; Sbplx (Rowan 1990)
/// works with one.
nlopt::algorithm algorithm_for(std::size_t parameters) {
  return parameters >= 2 ? nlopt::LN_BOBYQA : nlopt::LN_SBPLX;
}

}  // namespace

int start_points(std::size_t parameters, int evaluations) {
  const int wanted = 8 * static_cast<int>(parameters);
  return std::clamp(wanted, 1, std::max(1, evaluations / 2));
}

FitSearch::FitSearch(Evaluator& evaluator, const SearchSettings& settings)
    : evaluator_(evaluator), settings_(settings), count_(evaluator.parameters().size()) {}

void FitSearch::start() {
  const auto points = hypercube(evaluator_.parameters(), start_points(count_, settings_.evaluations), settings_.seed);
  starts_.resize(points.size());
  for_each_task(points.size(), settings_.parallel, [&](std::size_t k) {
    starts_[k] = evaluator_.evaluate(points[k], {Stage::start, k, 0});
  });
  for (const Evaluation& one : starts_) {
    seconds_ += one.seconds / static_cast<double>(starts_.size());
    penalty_ = one.failed() ? penalty_ : std::max(penalty_, 3.0 * one.misfit);
  }
  std::stable_sort(starts_.begin(), starts_.end(), is_better);
  if (starts_.front().failed()) {
    throw Error(ExitCode::numerical_failure,
                fmt::format("none of {} runs between the bounds gave a misfit; the first: {}", starts_.size(),
                            starts_.front().message));
  }
}

double FitSearch::objective(const Evaluation& evaluation) const {
  const double misfit = evaluation.failed() ? penalty_ : evaluation.misfit;
  return std::pow(misfit / evaluator_.reference().signal, 2);
}

Evaluation FitSearch::descend(const FitPoint& start, const std::vector<std::size_t>& free, double step, int budget,
                              double enough, Origin& origin) {
  Evaluation best;
  best.misfit = std::numeric_limits<double>::quiet_NaN();
  std::exception_ptr problem;
  Objective evaluate = [&](const std::vector<double>& x) {
    FitPoint point = start;
    for (std::size_t k = 0; k < free.size(); ++k) {
      point[free[k]] = std::clamp(x[k], 0.0, 1.0);
    }
    try {
      const Evaluation now = evaluator_.evaluate(point, origin);
      ++origin.step;
      best = best.point.empty() || is_better(now, best) ? now : best;
      return objective(now);
    } catch (...) {
      problem = std::current_exception();
      throw nlopt::forced_stop();
    }
  };
  nlopt::opt search(algorithm_for(free.size()), static_cast<unsigned>(free.size()));
  search.set_min_objective([](const std::vector<double>& x, std::vector<double>&,
                              void* data) { return (*static_cast<Objective*>(data))(x); },
                           &evaluate);
  search.set_lower_bounds(0.0);
  search.set_upper_bounds(1.0);
  search.set_initial_step(step);
  search.set_xtol_abs(settled);
  search.set_maxeval(budget);
  search.set_stopval(std::pow(enough / evaluator_.reference().signal, 2));
  std::vector<double> x;
  for (const std::size_t parameter : free) {
    x.push_back(start[parameter]);
  }
  try {
    search.optimize(x);
  } catch (const nlopt::forced_stop&) {
    std::rethrow_exception(problem);
  } catch (const std::runtime_error&) {
    // NLopt is as far down as numbers go, or gives up: what was found stands.
  }
  return best;
}

void FitSearch::descend_from_starts() {
  std::vector<FitPoint> from{starts_.front().point};
  const auto second = std::find_if(starts_.begin(), starts_.end(), [&](const Evaluation& one) {
    return !one.failed() && distance(one.point, from.front()) > far_apart;
  });
  if (second != starts_.end()) {
    from.push_back(second->point);
  }
  const int left = std::max(0, settings_.evaluations - static_cast<int>(starts_.size()));
  const int budget = left / static_cast<int>(from.size());
  if (budget == 0) {
    return;
  }
  std::vector<std::size_t> all(count_);
  std::iota(all.begin(), all.end(), std::size_t{0});
  for_each_task(from.size(), settings_.parallel, [&](std::size_t k) {
    Origin origin{Stage::search, k, 0};
    descend(from[k], all, first_step, budget, 0.0, origin);
  });
}

Evaluation FitSearch::fit_others(const FitPoint& guess, std::size_t parameter, Origin& origin) {
  std::vector<std::size_t> others;
  for (std::size_t k = 0; k < count_; ++k) {
    if (k != parameter) {
      others.push_back(k);
    }
  }
  if (others.empty()) {
    Evaluation now = evaluator_.evaluate(guess, origin);
    ++origin.step;
    return now;
  }
  const double step = std::max(nearest_look, 0.5 * distance(guess, result_.best.point));
  return descend(guess, others, std::min(step, first_step), runs_a_look * static_cast<int>(others.size()),
                 result_.limit, origin);
}

FitPoint FitSearch::find_end(std::size_t parameter, double direction, Origin origin) {
  const FitPoint& best = result_.best.point;
  const double farthest = direction > 0.0 ? 1.0 - best[parameter] : best[parameter];
  FitPoint inside = best;
  double fits = 0.0, fails = farthest;
  // Where a valley runs straight, the others follow in proportion.
  const auto look = [&](double far) {
    FitPoint guess = best;
    for (std::size_t k = 0; k < count_ && fits > 0.0; ++k) {
      guess[k] = std::clamp(best[k] + (inside[k] - best[k]) * far / fits, 0.0, 1.0);
    }
    guess[parameter] = std::clamp(best[parameter] + direction * far, 0.0, 1.0);
    const Evaluation now = fit_others(guess, parameter, origin);
    const bool is_inside = !now.failed() && now.misfit <= result_.limit;
    if (is_inside) {
      inside = now.point;
    }
    (is_inside ? fits : fails) = far;
    return is_inside;
  };
  for (double far = nearest_look; fits < farthest; far *= 2.0) {
    if (!look(std::min(far, farthest))) {
      break;
    }
  }
  for (int k = 0; k < bisections && fits < fails; ++k) {
    look(0.5 * (fits + fails));
  }
  return inside;
}

void FitSearch::take_best() {
  for (const Evaluation& one : evaluator_.log()) {
    if (is_better(one, result_.best)) {
      result_.best = one;
    }
  }
  result_.limit = std::hypot(result_.best.misfit, settings_.tolerance);
}

void FitSearch::find_ranges() {
  result_.ranges.assign(count_, {});
  for_each_task(2 * count_, settings_.parallel, [&](std::size_t k) {
    const Origin origin{Stage::range, next_task_ + k, 0};
    FitRange& range = result_.ranges[k / 2];
    (k % 2 == 0 ? range.low : range.high) = find_end(k / 2, k % 2 == 0 ? -1.0 : 1.0, origin);
  });
  next_task_ += 2 * count_;
  widen_ranges();
}

/// A run that fits belongs to the range of every parameter, whatever it was made for.
void FitSearch::widen_ranges() {
  for (const Evaluation& one : evaluator_.log()) {
    for (std::size_t k = 0; k < count_ && !one.failed() && one.misfit <= result_.limit; ++k) {
      FitRange& range = result_.ranges[k];
      range.low = one.point[k] < range.low[k] ? one.point : range.low;
      range.high = one.point[k] > range.high[k] ? one.point : range.high;
    }
  }
}

void FitSearch::draw_map() {
  const std::size_t axes = std::min<std::size_t>(count_, 2);
  if (settings_.map == 0) {
    return;
  }
  for (std::size_t k = 0; k < axes; ++k) {
    const double at = result_.best.point[k];
    const double below = std::max(smallest_map, widest_map * (at - result_.ranges[k].low[k]));
    const double above = std::max(smallest_map, widest_map * (result_.ranges[k].high[k] - at));
    result_.windows.push_back({std::max(0.0, at - below), std::min(1.0, at + above)});
  }
  const auto side = static_cast<std::size_t>(settings_.map) * (axes == 1 ? 3 : 1);  // a curve is cheap
  result_.map.resize(axes == 1 ? side : side * side);
  const auto place = [&](std::size_t axis, std::size_t k) {
    const MapWindow& window = result_.windows[axis];
    return window.from + (window.to - window.from) * static_cast<double>(k) / static_cast<double>(side - 1);
  };
  for_each_task(result_.map.size(), settings_.parallel, [&](std::size_t k) {
    FitPoint point = result_.best.point;
    point[0] = place(0, k % side);
    if (axes == 2) {
      point[1] = place(1, k / side);
    }
    result_.map[k] = evaluator_.evaluate(point, {Stage::map, k, 0});
  });
}

FitResult FitSearch::finish() {
  result_.best = starts_.front();
  descend_from_starts();
  take_best();
  for (int round = 0; round < most_rounds; ++round) {
    const double before = result_.best.misfit;
    find_ranges();
    take_best();
    if (before - result_.best.misfit <= 0.1 * settings_.tolerance) {
      break;
    }
  }
  draw_map();
  result_.evaluated = evaluator_.log();
  return std::move(result_);
}

}  // namespace sandsim::cli
