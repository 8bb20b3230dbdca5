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

  template <class Visitor>
  void visit(const Visitor& visitor) const {
    for (std::size_t j = 0; j < y_.size(); ++j) {
      for (std::size_t i = 0; i < x_.size(); ++i) visitor(x_[i], y_[j], depth_[j * x_.size() + i]);
    }
  }

 private:
  std::vector<double> x_, y_;  // [m]
  hdf5::Handle dataset_;
  std::vector<double> depth_;  // [m]
};

std::optional<Deposit> read_deposit(const SeriesReader& series) {
  const StoredVariable* depth = series.find("depth");
  if (depth == nullptr || !depth->has_dimensions({"time", "y", "x"}) || series.frames() == 0) return std::nullopt;
  DepthFrames frames(series);
  std::optional<std::pair<double, double>> centre;
  double deepest = 0.0;
  for (std::size_t frame = 0; frame < series.frames(); ++frame) {
    frames.load(frame);
    deepest = std::max(deepest, frames.largest());
    if (!centre && deepest > 0.0) centre = frames.centre_of_mass();
  }
  if (!centre) return std::nullopt;
  Deposit deposit{-INFINITY, frames.largest(), 0.0};
  frames.visit([&](double x, double y, double h) {
    if (h <= deposit_threshold * deepest) return;
    deposit.front = std::max(deposit.front, x);
    deposit.runout = std::max(deposit.runout, std::hypot(x - centre->first, y - centre->second));
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
  if (report.run.exit_code != ExitCode::done) return report;
  const hdf5::Session session;
  try {
    report.deposit = read_deposit(SeriesReader(files.series));
  } catch (const hdf5::Failure& failure) {
    throw InputError(fmt::format("{}: {}", files.series.string(), failure.what()));
  }
  return report;
}

}  // namespace sandsim::cli
