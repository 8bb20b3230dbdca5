#include "cli/cases/case_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "io/output/output_directory.hpp"
#include "io/output/series_reader.hpp"
#include "solver/errors.hpp"

namespace sandsim::cli {

namespace fs = std::filesystem;

namespace {

/// The frames of depth, one in memory at a time.
class DepthFrames {
 public:
  explicit DepthFrames(const SeriesReader& series)
      : x_(series.read_coordinate("x")),
        y_(series.read_coordinate("y")),
        dataset_(hdf5::open_dataset(series.file(), "depth")),
        depth_(x_.size() * y_.size()) {}

  void load(std::size_t frame) {
    hdf5::read(dataset_.id(), H5T_NATIVE_DOUBLE, depth_.data(), {{frame, 0, 0}, {1, y_.size(), x_.size()}});
  }

  double largest() const { return *std::max_element(depth_.begin(), depth_.end()); }

  std::pair<double, double> centre_of_mass() const {
    double sum = 0.0, sum_x = 0.0, sum_y = 0.0;
    visit([&](double x, double y, double depth) {
      sum += depth;
      sum_x += x * depth;
      sum_y += y * depth;
    });
    return {sum_x / sum, sum_y / sum};
  }

  /// Calls visitor(x, y, depth) for each cell.
  template <class Visitor>
  void visit(const Visitor& visitor) const {
    for (std::size_t j = 0; j < y_.size(); ++j) {
      for (std::size_t i = 0; i < x_.size(); ++i) {
        visitor(x_[i], y_[j], at(i, j));
      }
    }
  }

  /// Calls visitor(x, y) for the centres of cells deeper than the threshold, and for the points between them and their
  /// neighbours at which the depth, taken as linear, falls to it.
  template <class Visitor>
  void visit_outline(double threshold, const Visitor& visitor) const {
    const auto visit_between = [&](std::size_t i, std::size_t j, std::size_t m, std::size_t n) {
      const double here = at(i, j), there = at(m, n);
      if ((here > threshold) == (there > threshold)) {
        return;
      }
      const double fraction = (here - threshold) / (here - there);
      visitor(x_[i] + fraction * (x_[m] - x_[i]), y_[j] + fraction * (y_[n] - y_[j]));
    };
    for (std::size_t j = 0; j < y_.size(); ++j) {
      for (std::size_t i = 0; i < x_.size(); ++i) {
        if (at(i, j) > threshold) {
          visitor(x_[i], y_[j]);
        }
        if (i + 1 < x_.size()) {
          visit_between(i, j, i + 1, j);
        }
        if (j + 1 < y_.size()) {
          visit_between(i, j, i, j + 1);
        }
      }
    }
  }

 private:
  double at(std::size_t i, std::size_t j) const { return depth_[j * x_.size() + i]; }

  std::vector<double> x_, y_;  // [m]
  hdf5::Handle dataset_;
  std::vector<double> depth_;  // [m]
};

std::optional<Deposit> read_deposit(const SeriesReader& series) {
  const StoredVariable* depth = series.find("depth");
  if (depth == nullptr || !depth->has_dimensions({"time", "y", "x"}) || series.frames() == 0) {
    return std::nullopt;
  }
  DepthFrames frames(series);
  double deepest = 0.0;
  std::pair<double, double> centre;
  for (std::size_t frame = 0; frame < series.frames() && deepest == 0.0; ++frame) {
    frames.load(frame);
    deepest = frames.largest();
    if (deepest > 0.0) {
      centre = frames.centre_of_mass();
    }
  }
  if (deepest == 0.0) {
    return std::nullopt;
  }
  frames.load(series.frames() - 1);
  deepest = std::max(deepest, frames.largest());
  Deposit deposit{-INFINITY, frames.largest(), 0.0};
  frames.visit_outline(deposit_threshold * deepest, [&](double x, double y) {
    deposit.front = std::max(deposit.front, x);
    deposit.runout = std::max(deposit.runout, std::hypot(x - centre.first, y - centre.second));
  });
  // All sand has left, or what is left is thinner than an outline.
  return std::isfinite(deposit.front) ? std::optional(deposit) : std::nullopt;
}

}  // namespace

std::optional<CaseReport> read_case_report(const fs::path& directory) {
  const OutputFiles files(directory);
  CaseReport report;
  try {
    StoredRun stored = read_run_report(files.report);
    report.run = std::move(stored.report);
    report.scene_hash = std::move(stored.scene_hash);
  } catch (const InputError&) {
    return std::nullopt;
  }
  if (report.run.exit_code != ExitCode::done) {
    return report;
  }
  const hdf5::Session session;
  try {
    const SeriesReader series(files.series);
    report.has_one_row = series.read_coordinate("y").size() == 1;
    report.deposit = read_deposit(series);
  } catch (const hdf5::Failure& failure) {
    throw InputError(fmt::format("{}: {}", files.series.string(), failure.what()));
  }
  return report;
}

}  // namespace sandsim::cli
