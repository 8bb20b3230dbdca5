#include "io/output/run_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>

#include "io/output/series_reader.hpp"
#include "solver/errors.hpp"
#include "solver/reference/compare.hpp"

namespace sandsim {

namespace fs = std::filesystem;

namespace {

/// The depths of a series, frame by frame.
class Depths {
 public:
  explicit Depths(const fs::path& path) : series_(path), grid_(series_.grid()) {
    const StoredVariable* depth = series_.find("depth");
    if (depth == nullptr || !depth->has_dimensions({"time", "y", "x"})) {
      throw hdf5::Failure("it holds no depth over time; the run needs output.fields with depth");
    }
    if (series_.frames() == 0) throw hdf5::Failure("it has no frames");
    dataset_ = hdf5::open_dataset(series_.file(), "depth");
  }

  const Grid& grid() const { return grid_; }
  const std::vector<double>& times() const { return series_.times(); }

  /// [m] ny * nx values.
  std::vector<double> at(std::size_t frame) const {
    std::vector<double> values(grid_.cell_count());
    const auto nx = static_cast<hsize_t>(grid_.cells[0]), ny = static_cast<hsize_t>(grid_.cells[1]);
    hdf5::read(dataset_.id(), H5T_NATIVE_DOUBLE, values.data(), {{frame, 0, 0}, {1, ny, nx}});
    return values;
  }
  /// Whether nothing moved in the last frame, so that it holds ever after.
  bool ends_at_rest() const {
    return hdf5::read_all<std::int64_t>(series_.file(), "moving_cells").at(series_.frames() - 1) == 0;
  }

 private:
  SeriesReader series_;
  Grid grid_;
  hdf5::Handle dataset_;
};

template <class Result>
Result with_depths(const fs::path& given, const std::function<Result(const Depths&, const std::string&)>& read) {
  const fs::path path = series_path(given);
  const hdf5::Session session;
  try {
    return read(Depths(path), path.string());
  } catch (const hdf5::Failure& failure) {
    throw InputError(fmt::format("{}: {}", path.string(), failure.what()));
  }
}

}  // namespace

FrontCurve read_run_front(const fs::path& path, double threshold) {
  return with_depths<FrontCurve>(path, [threshold](const Depths& depths, const std::string& name) {
    FrontCurve curve{name, {}, {}};
    for (std::size_t frame = 0; frame < depths.times().size(); ++frame) {
      const double position = front(depths.grid(), depths.at(frame), threshold);
      if (std::isnan(position)) continue;
      curve.time.push_back(depths.times()[frame]);
      curve.front.push_back(position);
    }
    return curve;
  });
}

Profile read_run_profile(const fs::path& path, double time) {
  return with_depths<Profile>(path, [time](const Depths& depths, const std::string& name) {
    const std::vector<double>& times = depths.times();
    if (!depths.grid().one_dimensional()) throw hdf5::Failure("more than one row of cells: it has no profile along x");
    if (time < times.front() || (time > times.back() && !depths.ends_at_rest())) {
      throw hdf5::Failure(
          fmt::format("{:g} s lies outside of its frames, {:g} to {:g} s", time, times.front(), times.back()));
    }
    const auto after = std::lower_bound(times.begin(), times.end(), std::min(time, times.back()));
    const auto next = static_cast<std::size_t>(after - times.begin());
    Profile profile{name, {}, depths.at(next)};
    if (*after > time) {
      const std::vector<double> before = depths.at(next - 1);
      const double weight = (*after - time) / (*after - times[next - 1]);
      for (std::size_t i = 0; i < before.size(); ++i) profile.depth[i] += weight * (before[i] - profile.depth[i]);
    }
    for (int i = 0; i < depths.grid().cells[0]; ++i) profile.x.push_back(depths.grid().x(i));
    return profile;
  });
}

}  // namespace sandsim
