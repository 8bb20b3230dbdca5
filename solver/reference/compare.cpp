#include "solver/reference/compare.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "solver/reference/exact_now.hpp"
#include "solver/reference/numeric.hpp"
#include "solver/reference/piecewise_linear.hpp"
#include "solver/reference/restriction.hpp"

namespace sandsim {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

ErrorReport report_against(const std::string& against, double time) {
  ErrorReport report;
  report.against = against;
  report.time = time;
  return report;
}

/// Cell averages of an exact solution; NaN in cells that reach to smaller x than it holds.
std::vector<double> cell_averages(const Grid& grid, const ExactNow& now) {
  std::vector<double> values(static_cast<std::size_t>(grid.cells[0]));
  for (int i = 0; i < grid.cells[0]; ++i) {
    const double left = grid.origin[0] + i * grid.spacing;
    values[static_cast<std::size_t>(i)] = left < now.from ? nan : cell_average(now.depth, left, grid.spacing);
  }
  return values;
}

/// Norms over the cells whose reference is known.
void add_norms(ErrorReport& report, const Grid& grid, std::span<const double> depth,
               std::span<const double> reference) {
  double l1 = 0.0, l2 = 0.0, linf = 0.0, size = 0.0;
  ErrorReport::Height height;
  std::size_t known = 0;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    if (std::isnan(reference[i])) continue;
    const double error = std::abs(depth[i] - reference[i]);
    l1 += error;
    l2 += error * error;
    linf = std::max(linf, error);
    size += std::abs(reference[i]);
    height.computed = std::max(height.computed, depth[i]);
    height.reference = std::max(height.reference, reference[i]);
    ++known;
  }
  if (known == 0) return;
  const double cell = grid.one_dimensional() ? grid.spacing : grid.spacing * grid.spacing;
  report.l1 = l1 * cell;
  report.l2 = std::sqrt(l2 * cell);
  report.linf = linf;
  report.height = height;
  if (size > 0.0) report.l1_relative = l1 / size;
}

/// Where an exact depth, falling with x, crosses a threshold inside the grid.
std::optional<double> exact_front(const Grid& grid, const ExactNow& now, double threshold) {
  if (threshold == 0.0) return std::isnan(now.tip) ? std::nullopt : std::optional(now.tip);
  if (!now.depth) return std::nullopt;
  const double first = std::max(grid.origin[0], now.from);
  const double last = grid.origin[0] + grid.cells[0] * grid.spacing;
  if (!(now.depth(first) > threshold) || now.depth(last) > threshold) return std::nullopt;
  return bisect([&](double x) { return threshold - now.depth(x); }, first, last);
}

void append(std::string& note, const std::string& part) {
  if (!part.empty()) note += (note.empty() ? "" : "; ") + part;
}

ErrorReport compare_exact(const Scene& scene, const InitialState& initial, double time, std::span<const double> depth) {
  const ExactNow now = exact_now(scene, initial, time);
  ErrorReport report = report_against(now.name, time);
  if (now.depth) add_norms(report, scene.grid, depth, cell_averages(scene.grid, now));
  std::vector<double> thresholds = scene.reference->front_depths;
  if (std::find(thresholds.begin(), thresholds.end(), 0.0) == thresholds.end())
    thresholds.insert(thresholds.begin(), 0.0);
  for (const double threshold : thresholds) {
    report.fronts.push_back({threshold, front(scene.grid, depth, threshold), exact_front(scene.grid, now, threshold)});
  }
  append(report.note, now.problem.empty() ? "" : "not compared: " + now.problem);
  append(report.note, now.limit);
  if (now.depth && now.from > scene.grid.origin[0]) {
    append(report.note, "norms over x > " + std::to_string(now.from) + " m, where no wall has been felt");
  }
  return report;
}

ErrorReport compare_profile(const Scene& scene, const Profile& profile, const std::string& kind, double time,
                            std::span<const double> depth) {
  ErrorReport report = report_against(kind + " " + profile.file, time);
  const Grid& grid = scene.grid;
  const bool missing = profile.x.empty();
  if (missing) report.note = "the file " + profile.file + " is missing: nothing to compare with";
  const PiecewiseLinear table(profile.x, profile.depth);
  if (!missing && !grid.one_dimensional()) {
    report.note = "not compared: the scene is not one-dimensional";
  } else if (!missing) {
    std::vector<double> reference(static_cast<std::size_t>(grid.cells[0]));
    for (int i = 0; i < grid.cells[0]; ++i) {
      const double left = grid.origin[0] + i * grid.spacing;
      reference[static_cast<std::size_t>(i)] = table.mean(left, left + grid.spacing);
    }
    add_norms(report, grid, depth, reference);
  }
  for (const double threshold : scene.reference->front_depths) {
    const double known = missing ? nan : table.last_crossing(threshold);
    report.fronts.push_back(
        {threshold, front(grid, depth, threshold), std::isnan(known) ? std::nullopt : std::optional(known)});
  }
  return report;
}

ErrorReport compare_front(const Scene& scene, const FrontCurve& curve, double time, std::span<const double> depth) {
  ErrorReport report = report_against("measured front " + curve.file, time);
  std::optional<double> known;
  if (curve.time.empty()) {
    report.note = "the file " + curve.file + " is missing: nothing to compare with";
  } else if (time < curve.time.front() || time > curve.time.back()) {
    report.note = "not compared: the table does not reach this time";
  } else {
    known = PiecewiseLinear(curve.time, curve.front)(time);
    report.note = "every threshold is set against the one measured front";
  }
  for (const double threshold : scene.reference->front_depths) {
    report.fronts.push_back({threshold, front(scene.grid, depth, threshold), known});
  }
  return report;
}

/// The front of one row, see front().
double row_front(const Grid& grid, std::span<const double> row, double threshold) {
  const double wet = std::max(threshold, 1e-8 * grid.spacing);
  for (std::size_t i = row.size(); i-- > 0;) {
    if (!(row[i] > wet)) continue;
    const double center = grid.x(static_cast<int>(i));
    if (threshold == 0.0 || i + 1 == row.size()) return center + 0.5 * grid.spacing;
    return center + grid.spacing * (row[i] - threshold) / (row[i] - row[i + 1]);
  }
  return nan;
}

}  // namespace

double front(const Grid& grid, std::span<const double> depth, double threshold) {
  const auto columns = static_cast<std::size_t>(grid.cells[0]);
  double farthest = nan;
  for (std::size_t j = 0; j < static_cast<std::size_t>(grid.cells[1]); ++j) {
    farthest = std::fmax(farthest, row_front(grid, depth.subspan(j * columns, columns), threshold));
  }
  return farthest;
}

std::vector<ErrorReport> compare(const Scene& scene, const InitialState& initial, double time,
                                 std::span<const double> depth) {
  std::vector<ErrorReport> reports;
  if (!scene.reference) return reports;
  const Reference& reference = *scene.reference;
  if (reference.exact) reports.push_back(compare_exact(scene, initial, time, depth));
  if (reference.profile) reports.push_back(compare_profile(scene, *reference.profile, "profile", time, depth));
  if (reference.measured_profile) {
    reports.push_back(compare_profile(scene, *reference.measured_profile, "measured profile", time, depth));
  }
  if (reference.measured_front) reports.push_back(compare_front(scene, *reference.measured_front, time, depth));
  if (reports.empty() && !reference.front_depths.empty()) {
    ErrorReport alone = report_against("nothing", time);
    alone.note = "the scene names no reference to compare with";
    for (const double threshold : reference.front_depths) {
      alone.fronts.push_back({threshold, front(scene.grid, depth, threshold), std::nullopt});
    }
    reports.push_back(alone);
  }
  return reports;
}

ErrorReport compare_fine(const Grid& grid, std::span<const double> depth, const Grid& fine_grid,
                         std::span<const double> fine, double time, std::span<const double> front_depths) {
  ErrorReport report = report_against("fine run", time);
  add_norms(report, grid, depth, restrict_to(grid, fine_grid, fine));
  for (const double threshold : front_depths) {
    const double known = front(fine_grid, fine, threshold);
    report.fronts.push_back(
        {threshold, front(grid, depth, threshold), std::isnan(known) ? std::nullopt : std::optional(known)});
  }
  return report;
}

ReferenceFrame reference_at(const Scene& scene, const InitialState& initial, double time) {
  ReferenceFrame frame{.depth = {}, .tip = nan};
  if (!scene.reference || !scene.reference->exact) return frame;
  const ExactNow now = exact_now(scene, initial, time);
  frame.tip = now.tip;
  if (now.depth) frame.depth = cell_averages(scene.grid, now);
  return frame;
}

}  // namespace sandsim
