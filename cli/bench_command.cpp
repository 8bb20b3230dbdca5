#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <ostream>
#include <utility>
#include <vector>

#include "cli/arithmetic_rate.hpp"
#include "cli/bench_step.hpp"
#include "cli/commands.hpp"
#include "cli/copy_bandwidth.hpp"
#include "cli/machine.hpp"
#include "cli/operation_count.hpp"
#include "cli/text.hpp"
#include "io/output/json.hpp"
#include "io/output/version.hpp"

namespace sandsim::cli {

namespace {

/// How much is measured, from the options.
struct Effort {
  int size = 0;
  int threads = 0;
  int repeats = 0;
  int steps = 0;  // a repeat
  std::size_t array_bytes = 0;
  std::vector<Precision> precisions;
};

Effort effort_of(const BenchArguments& arguments) {
  Effort effort;
  effort.size = arguments.quick ? std::min(arguments.size, 256) : arguments.size;
  effort.threads = arguments.threads > 0 ? arguments.threads : default_threads();
  effort.repeats = arguments.quick ? std::min(arguments.repeats, 2) : arguments.repeats;
  // About 4e7 cell-steps a repeat: tenths of a second, and too few steps for friction to stop anything.
  effort.steps = static_cast<int>(std::clamp(4e7 / (1.0 * effort.size * effort.size), 2.0, 100.0));
  effort.array_bytes = copy_array_bytes(arguments.quick);
  if (arguments.precision != "float64") {
    effort.precisions.push_back(Precision::float32);
  }
  if (arguments.precision != "float32") {
    effort.precisions.push_back(Precision::float64);
  }
  return effort;
}

struct StepRow {
  StepCase which;
  StepSpeed speed;
  double floor = 0.0;  // [cell-steps/s] that the memory allows
  OperationCount operations;
  double arithmetic_floor = 0.0;  // [cell-steps/s] that the arithmetic allows

  double percent_of_arithmetic() const { return 100.0 * speed.cell_steps_per_second.median / arithmetic_floor; }
  double percent() const { return 100.0 * speed.cell_steps_per_second.median / floor; }
  const char* precision() const { return which.precision == Precision::float32 ? "float32" : "float64"; }
  const char* terrain() const { return which.terrain ? "wavy" : "flat"; }
};

/// The slower kind of operation alone: the faster one runs beside it.
double arithmetic_floor(const OperationCount& count, const ArithmeticRate& rate) {
  return 1.0 / std::max(count.simple / rate.simple.median, count.divided / rate.divided.median);
}

struct StartRow {
  int columns = 0;
  int rows = 0;
  Measurement seconds;
};

void print_head(std::ostream& out, const Effort& effort, const Measurement& bandwidth) {
  out << fmt::format("{}\n{}, {} thread{}, {}\n\n", source_line(), processor_name(), effort.threads,
                     effort.threads == 1 ? "" : "s", vector_instructions());
  out << fmt::format("copy bandwidth  {}/s (read + written, ordinary stores; {}/s to {}/s), arrays of {}\n",
                     format_bytes(bandwidth.median), format_bytes(bandwidth.least), format_bytes(bandwidth.most),
                     format_bytes(static_cast<double>(effort.array_bytes)));
}

void print_columns(std::ostream& out, const Effort& effort) {
  out << fmt::format("\nstep, {0} x {0} cells, all moving, periodic; M cell-steps/s, median of {1} x {2} steps\n",
                     effort.size, effort.repeats, effort.steps);
  out << fmt::format("{:<18}{:<9}{:<8}{:>8}{:>18}{:>14}{:>14}{:>10}{:>22}{:>12}{:>10}\n", "scheme", "", "terrain",
                     "speed", "range", "bytes a cell", "floor (bytes)", "of floor", "operations + div/sqrt",
                     "their floor", "of floor");
}

void print_rate(std::ostream& out, Precision precision, const ArithmeticRate& rate) {
  out << fmt::format("{} arithmetic  {:.1f} G additions and multiplications/s, {:.2f} G divisions and square roots/s\n",
                     precision == Precision::float32 ? "float32" : "float64", rate.simple.median / 1e9,
                     rate.divided.median / 1e9);
}

void print_row(std::ostream& out, const StepRow& row) {
  const Measurement& speed = row.speed.cell_steps_per_second;
  out << fmt::format("{:<18}{:<9}{:<8}{:>8.1f}{:>18}{:>14.1f}{:>14}{:>8.1f} %{:>22}{:>12.0f}{:>8.1f} %\n",
                     scheme_name(row.which), row.precision(), row.terrain(), speed.median / 1e6,
                     fmt::format("{:.1f} to {:.1f}", speed.least / 1e6, speed.most / 1e6), row.speed.bytes_per_cell,
                     fmt::format("{:.0f} ({:.0f})", row.floor / 1e6, floor_bytes(row.which)), row.percent(),
                     fmt::format("{} + {}", row.operations.simple, row.operations.divided), row.arithmetic_floor / 1e6,
                     row.percent_of_arithmetic());
  if (row.speed.moving < 1.0) {
    out << fmt::format("  only {:.2f} % of the cells moved to the end\n", 100.0 * row.speed.moving);
  }
  out << std::flush;
}

void print_start(std::ostream& out, const StartRow& row) {
  out << fmt::format("solver start to first step, {} x {} cells: {} ({} to {})\n", row.columns, row.rows,
                     format_duration(row.seconds.median), format_duration(row.seconds.least),
                     format_duration(row.seconds.most));
}

void add_measurement(JsonWriter& json, const char* key, const Measurement& measured) {
  json.begin_object(key).member("median", measured.median).member("min", measured.least);
  json.member("max", measured.most).end_object();
}

std::string bench_json(const Effort& effort, const Measurement& bandwidth, const std::vector<StepRow>& rows,
                       const std::vector<StartRow>& starts) {
  JsonWriter json;
  json.begin_object().member("version", version()).member("commit", commit());
  json.member("processor", processor_name()).member("threads", effort.threads);
  json.member("vector_instructions", vector_instructions());
  add_measurement(json, "copy_bytes_per_second", bandwidth);
  json.member("copy_array_bytes", effort.array_bytes);
  json.member("size", effort.size).member("repeats", effort.repeats).member("steps_per_repeat", effort.steps);
  json.begin_array("steps");
  for (const StepRow& row : rows) {
    json.begin_object().member("scheme", row.which.scheme == Scheme::paper ? "paper" : "balanced");
    json.member("order", row.which.order).member("precision", row.precision()).member("terrain", row.terrain());
    add_measurement(json, "cell_steps_per_second", row.speed.cell_steps_per_second);
    json.member("bytes_per_cell", row.speed.bytes_per_cell).member("floor_bytes_per_cell", floor_bytes(row.which));
    json.member("floor_cell_steps_per_second", row.floor).member("percent_of_floor", row.percent());
    json.member("simple_operations", row.operations.simple).member("divisions_and_roots", row.operations.divided);
    json.member("arithmetic_floor_cell_steps_per_second", row.arithmetic_floor);
    json.member("percent_of_arithmetic_floor", row.percent_of_arithmetic());
    json.member("moving_fraction", row.speed.moving).end_object();
  }
  json.end_array().begin_array("start_to_first_step");
  for (const StartRow& row : starts) {
    json.begin_object().member("columns", row.columns).member("rows", row.rows);
    add_measurement(json, "seconds", row.seconds);
    json.end_object();
  }
  return json.end_array().end_object().text();
}

}  // namespace

ExitCode bench_command(const BenchArguments& arguments, Console& console) {
  const Effort effort = effort_of(arguments);
  const bool table = !arguments.json;
  const Measurement bandwidth = measure_copy_bandwidth(effort.array_bytes, effort.threads, std::max(effort.repeats, 3));
  if (table) {
    print_head(console.out, effort, bandwidth);
  }
  std::map<Precision, ArithmeticRate> rates;
  for (const Precision precision : effort.precisions) {
    rates[precision] = measure_arithmetic(precision, effort.threads, std::max(effort.repeats, 3));
    if (table) {
      print_rate(console.out, precision, rates[precision]);
    }
  }
  if (table) {
    print_columns(console.out, effort);
  }
  std::vector<StepRow> rows;
  for (const StepCase& which : step_cases(effort.precisions)) {
    const StepSpeed speed = measure_step(which, effort.size, effort.threads, effort.repeats, effort.steps);
    const OperationCount operations = count_operations(which.scheme == Scheme::paper, which.order, !which.terrain);
    rows.push_back({which, speed, bandwidth.median / floor_bytes(which), operations,
                    arithmetic_floor(operations, rates[which.precision])});
    if (table) {
      print_row(console.out, rows.back());
    }
  }
  if (table) {
    console.out << '\n';
  }
  std::vector<StartRow> starts;
  for (const auto& [columns, lines] : {std::pair(160, 1), std::pair(512, 512)}) {
    starts.push_back({columns, lines, measure_start(columns, lines, effort.threads, std::max(effort.repeats, 3))});
    if (table) {
      print_start(console.out, starts.back());
    }
  }
  if (!table) {
    console.out << bench_json(effort, bandwidth, rows, starts);
  }
  return ExitCode::done;
}

}  // namespace sandsim::cli
