#include "io/output/result_info.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "io/output/output_directory.hpp"
#include "io/output/series_reader.hpp"
#include "io/output/series_writer.hpp"
#include "solver/errors.hpp"

namespace sandsim {
namespace {

namespace fs = std::filesystem;

struct Range {
  double smallest = std::numeric_limits<double>::infinity();
  double largest = -std::numeric_limits<double>::infinity();

  void include(const std::vector<double>& values) {
    for (const double value : values) {
      if (std::isnan(value)) continue;
      smallest = std::min(smallest, value);
      largest = std::max(largest, value);
    }
  }
  std::string text() const {
    return smallest <= largest ? fmt::format("{:.6g} to {:.6g}", smallest, largest) : "no values";
  }
};

std::string line(const std::string& name, const std::string& value) {
  return fmt::format("{:<14}{}\n", name, value);
}

/// Range of the completed frames. Read one slice of the slowest dimension at a time: a series may exceed the memory.
Range range_of(const SeriesReader& series, const StoredVariable& variable) {
  Range range;
  std::vector<hsize_t> count = variable.extent;
  hsize_t slices = count.front();
  if (variable.dimensions.front() == "time") slices = std::min<hsize_t>(slices, series.frames());
  count.front() = count.size() == 1 ? slices : 1;
  hsize_t size = 1;
  for (const hsize_t length : count) size *= length;
  if (size == 0) return range;
  const hdf5::Handle dataset = hdf5::open_dataset(series.file(), variable.name);
  std::vector<double> values(size);
  std::vector<hsize_t> start(count.size(), 0);
  for (hsize_t slice = 0; slice < slices; slice += count.front()) {
    start.front() = slice;
    hdf5::read(dataset.id(), H5T_NATIVE_DOUBLE, values.data(), {start, count});
    range.include(values);
  }
  return range;
}

std::string describe_variable(const SeriesReader& series, const StoredVariable& variable) {
  const std::string head = fmt::format("{}({})", variable.name, fmt::join(variable.dimensions, ", "));
  if (!variable.numeric || variable.extent.empty()) return fmt::format("  {}\n", head);
  std::string range;
  try {
    range = range_of(series, variable).text();
  } catch (const hdf5::Failure& failure) {
    range = fmt::format("unreadable: {}", failure.what());
  }
  return fmt::format("  {:<32} {:<10}{}\n", head, variable.units, range);
}

std::string describe_frames(const SeriesReader& series, bool partial) {
  std::string text = std::to_string(series.frames());
  if (series.frames() > 0)
    text += fmt::format(", time {:.6g} to {:.6g} s", series.times().front(), series.times().back());
  if (partial) text += "; not finished: the run is still going on, was stopped or failed";
  return text;
}

std::string describe_grid(const SeriesReader& series) {
  const std::vector<double> x = series.read_coordinate("x");
  const std::vector<double> y = series.read_coordinate("y");
  std::string text = fmt::format("{} x {} cells", x.size(), y.size());
  if (!x.empty() && !y.empty()) {
    text +=
        fmt::format(", centres x {:.6g} to {:.6g} m, y {:.6g} to {:.6g} m", x.front(), x.back(), y.front(), y.back());
  }
  return text;
}

std::string describe_series(const fs::path& path) {
  const hdf5::Session session;
  try {
    const SeriesReader series(path);
    std::string text =
        line("series", fmt::format("{} ({:.3g} MB)", path.string(), static_cast<double>(fs::file_size(path)) / 1e6));
    for (const char* name : {"title", "source", "device", "precision"}) text += line(name, series.attribute(name));
    text += line("grid", describe_grid(series));
    text += line("frames", describe_frames(series, path.extension() == ".partial"));
    text += "variables\n";
    for (const StoredVariable& variable : series.variables()) {
      if (!variable.bare_dimension) text += describe_variable(series, variable);
    }
    return text;
  } catch (const hdf5::Failure& failure) {
    throw InputError(fmt::format("{}: {}", path.string(), failure.what()));
  }
}

std::string describe_stages(const YAML::Node& stages) {
  std::string text;
  for (const YAML::Node& stage : stages) {
    text +=
        fmt::format("  {:<32}{:.4g} s, {} launches, {:.4g} bytes\n", stage["name"].as<std::string>(),
                    stage["seconds"].as<double>(), stage["launches"].as<std::string>(), stage["bytes"].as<double>());
  }
  return text;
}

/// The run report is JSON, which YAML contains.
std::string describe_run(const fs::path& path) {
  const YAML::Node run = YAML::LoadFile(path.string());
  std::string text = line("run", path.string());
  for (const char* key :
       {"status",       "message",        "scheme",       "order",          "precision", "device",
        "threads",      "cells",          "steps",        "simulated_time", "wall_time", "cell_steps_per_second",
        "memory_bytes", "volume_initial", "volume_final", "volume_error",   "dt_min",    "dt_max",
        "at_rest",      "stop_time"}) {
    const YAML::Node value = run[key];
    if (!value || value.IsNull() || !value.IsScalar() || value.Scalar().empty()) continue;
    text += fmt::format("  {:<32}{}\n", key, value.Scalar());
  }
  for (const char* key : {"smallest_step", "failure"}) {
    const YAML::Node cell = run[key];
    if (!cell) continue;
    text += fmt::format("  {:<32}cell ({}, {}) at {} s: {}\n", key, cell["i"].as<std::string>(),
                        cell["j"].as<std::string>(), cell["time"].as<std::string>(), cell["cause"].as<std::string>());
  }
  for (const YAML::Node& error : run["errors"]) {
    const std::string relative = error["l1_relative"] ? error["l1_relative"].as<std::string>() : "unknown";
    text += fmt::format("  {:<32}relative L1 {}\n", "error against " + error["against"].as<std::string>(), relative);
  }
  if (run["stages"] && run["stages"].size() > 0) text += "stages\n" + describe_stages(run["stages"]);
  return text;
}

std::string describe_run_or_problem(const fs::path& path) {
  std::error_code ignored;
  if (!fs::exists(path, ignored)) return line("run", "no run.json beside it: the run has not ended, or was killed");
  try {
    return describe_run(path);
  } catch (const YAML::Exception& problem) {
    return line("run", fmt::format("{}: not a run report ({})", path.string(), problem.what()));
  }
}

}  // namespace

std::string describe_result(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(path, error)) throw InputError(fmt::format("{}: there is no such file or directory", path.string()));
  if (!fs::is_directory(path, error)) {
    return describe_series(path) + describe_run_or_problem(OutputFiles(path.parent_path()).report);
  }
  const OutputFiles files(path);
  for (const fs::path& series : {files.series, partial_series_path(files.series)}) {
    if (fs::exists(series, error)) return describe_series(series) + describe_run_or_problem(files.report);
  }
  if (fs::exists(files.report, error)) return describe_run_or_problem(files.report);
  throw InputError(fmt::format("{}: no result of sandsim: neither series.h5 nor run.json is there", path.string()));
}

}  // namespace sandsim
