#include "io/output/read_run_report.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <limits>

#include "solver/errors.hpp"

namespace sandsim {
namespace {

double number(const YAML::Node& node) {
  return node.IsNull() ? std::numeric_limits<double>::quiet_NaN() : node.as<double>();
}

std::optional<double> optional_number(const YAML::Node& node) {
  return node ? std::optional(number(node)) : std::nullopt;
}

std::string text(const YAML::Node& node) {
  return node ? node.as<std::string>() : std::string{};
}

void read_run(const YAML::Node& run, RunReport& report) {
  report.status = run["status"].as<std::string>();
  report.exit_code = static_cast<ExitCode>(run["exit_code"].as<int>());
  report.message = run["message"].as<std::string>();
  report.device = run["device"].as<std::string>();
  report.threads = run["threads"].as<int>();
  report.precision = run["precision"].as<std::string>();
  report.scheme = run["scheme"].as<std::string>();
  report.order = run["order"].as<int>();
}

void read_cost(const YAML::Node& run, RunReport& report) {
  report.cells = run["cells"].as<std::int64_t>();
  report.steps = run["steps"].as<std::int64_t>();
  report.frames = run["frames"].as<std::int64_t>();
  report.simulated_time = number(run["simulated_time"]);
  report.wall_time = number(run["wall_time"]);
  report.first_step_time = number(run["first_step_time"]);
  report.cell_steps_per_second = number(run["cell_steps_per_second"]);
  for (const YAML::Node& stage : run["stages"]) {
    report.stages.push_back({stage["name"].as<std::string>(), number(stage["seconds"]),
                             stage["launches"].as<std::int64_t>(), number(stage["bytes"])});
  }
  report.memory_bytes = run["memory_bytes"].as<std::int64_t>();
}

void read_outcome(const YAML::Node& run, RunReport& report) {
  report.ledger.initial = number(run["volume_initial"]);
  report.ledger.final = number(run["volume_final"]);
  report.ledger.in = number(run["volume_in"]);
  report.ledger.out = number(run["volume_out"]);
  report.ledger.clipped = number(run["volume_clipped"]);
  report.dt_min = number(run["dt_min"]);
  report.dt_max = number(run["dt_max"]);
  report.at_rest = run["at_rest"].as<bool>();
  report.stop_time = number(run["stop_time"]);
  report.max_slope_violation = number(run["max_slope_violation"]);
}

ErrorReport read_error(const YAML::Node& node) {
  ErrorReport error;
  error.against = node["against"].as<std::string>();
  error.time = number(node["time"]);
  error.l1 = optional_number(node["l1"]);
  error.l2 = optional_number(node["l2"]);
  error.linf = optional_number(node["linf"]);
  error.l1_relative = optional_number(node["l1_relative"]);
  for (const YAML::Node& front : node["fronts"]) {
    error.fronts.push_back({number(front["depth"]), number(front["computed"]), optional_number(front["reference"])});
  }
  if (const YAML::Node height = node["height"]) {
    error.height = {number(height["computed"]), number(height["reference"])};
  }
  error.note = text(node["note"]);
  return error;
}

Descent read_descent(const YAML::Node& node) {
  return {number(node["distance"]), number(node["drop"])};
}

RunoutReport read_runout(const YAML::Node& node) {
  RunoutReport runout;
  runout.above = number(node["above"]);
  runout.front = read_descent(node);
  runout.center_of_mass = read_descent(node["center_of_mass"]);
  runout.area = number(node["area"]);
  runout.max_depth = number(node["max_depth"]);
  runout.max_speed = number(node["max_speed"]);
  runout.deposit_front = number(node["deposit_front"]);
  runout.deposit_height = number(node["deposit_height"]);
  return runout;
}

}  // namespace

StoredRun read_run_report(const std::filesystem::path& path) {
  try {
    // JSON is YAML, but for numbers that it calls null.
    const YAML::Node run = YAML::LoadFile(path.string());
    StoredRun stored;
    read_run(run, stored.report);
    read_cost(run, stored.report);
    read_outcome(run, stored.report);
    if (const YAML::Node runout = run["runout"]) stored.report.runout = read_runout(runout);
    for (const YAML::Node& error : run["errors"]) stored.report.errors.push_back(read_error(error));
    stored.scene_hash = run["scene_hash"].as<std::string>();
    stored.started = text(run["started"]);
    return stored;
  } catch (const YAML::Exception& problem) {
    throw InputError(fmt::format("{}: no run report of sandsim ({})", path.string(), problem.what()));
  }
}

}  // namespace sandsim
