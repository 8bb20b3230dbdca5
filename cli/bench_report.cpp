#include "cli/bench_report.hpp"

#include <fmt/format.h>

#include <ostream>

#include "cli/machine.hpp"
#include "cli/text.hpp"
#include "io/output/json.hpp"
#include "io/output/version.hpp"

namespace sandsim::cli {

namespace {

std::string case_columns(const StepCase& which, int size) {
  return fmt::format("{:>6}  {:<18}{:<9}{:<6}", size, scheme_name(which), precision_name(which.precision),
                     which.terrain ? "wavy" : "flat");
}

void add_measurement(JsonWriter& json, const char* key, const Measurement& measured) {
  json.begin_object(key).member("median", measured.median).member("min", measured.least);
  json.member("max", measured.most).end_object();
}

void begin_case(JsonWriter& json, const StepCase& which, int size) {
  json.begin_object().member("size", size);
  json.member("scheme", which.scheme == Scheme::paper ? "paper" : "balanced").member("order", which.order);
  json.member("precision", precision_name(which.precision)).member("terrain", which.terrain ? "wavy" : "flat");
}

void add_step(JsonWriter& json, const StepRow& row) {
  begin_case(json, row.which, row.size);
  if (!row.skipped.empty()) {
    json.member("skipped", row.skipped).end_object();
    return;
  }
  json.member("steps_per_repeat", row.steps);
  add_measurement(json, "cell_steps_per_second", row.speed.cell_steps_per_second);
  json.member("steps_per_second", row.steps_per_second());
  json.member("bytes_per_cell", row.speed.bytes_per_cell).member("floor_bytes_per_cell", floor_bytes(row.which));
  json.member("floor_cell_steps_per_second", row.floor).member("percent_of_floor", row.percent());
  json.member("simple_operations", row.operations.simple).member("divisions_and_roots", row.operations.divided);
  json.member("arithmetic_floor_cell_steps_per_second", row.arithmetic_floor);
  json.member("percent_of_arithmetic_floor", row.percent_of_arithmetic());
  json.member("moving_fraction", row.speed.moving).end_object();
}

void add_rate(JsonWriter& json, Precision precision, const ArithmeticRate& rate) {
  json.begin_object().member("precision", precision_name(precision));
  add_measurement(json, "simple_operations_per_second", rate.simple);
  add_measurement(json, "divisions_and_roots_per_second", rate.divided);
  json.end_object();
}

void add_frame(JsonWriter& json, const FrameRow& row) {
  begin_case(json, row.which, row.size);
  add_measurement(json, "step_with_frame_seconds", row.cost.with_frame);
  add_measurement(json, "step_seconds", row.cost.step);
  json.member("overhead_seconds", row.cost.overhead()).end_object();
}

void add_ensemble(JsonWriter& json, const EnsembleRow& row) {
  begin_case(json, row.which, row.size);
  json.member("runs", row.runs);
  add_measurement(json, "steps_per_second", row.steps_per_second);
  json.end_object();
}

void add_start(JsonWriter& json, const StartRow& row) {
  json.begin_object().member("columns", row.columns).member("rows", row.rows);
  add_measurement(json, "seconds", row.seconds);
  json.end_object();
}

}  // namespace

void print_head(std::ostream& out, const BenchReport& report) {
  const Measurement& bandwidth = report.bandwidth;
  out << fmt::format("{}\n{}\n\n", source_line(), report.device.details);
  out << fmt::format("copy bandwidth  {}/s (read + written, {}; {}/s to {}/s), arrays of {}\n",
                     format_bytes(bandwidth.median), report.device.copies, format_bytes(bandwidth.least),
                     format_bytes(bandwidth.most), format_bytes(static_cast<double>(report.array_bytes)))
      << std::flush;
}

void print_rate(std::ostream& out, Precision precision, const ArithmeticRate& rate) {
  out << fmt::format("{} arithmetic  {:.1f} G additions and multiplications/s, {:.2f} G divisions and square roots/s\n",
                     precision_name(precision), rate.simple.median / 1e9, rate.divided.median / 1e9);
}

void print_columns(std::ostream& out, const BenchReport& report) {
  out << fmt::format("\nstep on size x size cells, all moving, periodic; M cell-steps/s, median of {} repeats\n",
                     report.repeats);
  out << fmt::format("{:>6}  {:<18}{:<9}{:<6}{:>9}{:>20}{:>10}{:>14}{:>15}{:>10}{:>22}{:>12}{:>10}\n", "size", "scheme",
                     "", "bed", "speed", "range", "steps/s", "bytes a cell", "floor (bytes)", "of floor",
                     "operations + div/sqrt", "their floor", "of floor");
}

void print_step(std::ostream& out, const StepRow& row) {
  out << case_columns(row.which, row.size);
  if (!row.skipped.empty()) {
    out << "  skipped: " << row.skipped << std::endl;
    return;
  }
  const Measurement& speed = row.speed.cell_steps_per_second;
  out << fmt::format("{:>9.1f}{:>20}{:>10.1f}{:>14.1f}{:>15}{:>8.1f} %{:>22}{:>12.0f}{:>8.1f} %\n", speed.median / 1e6,
                     fmt::format("{:.1f} to {:.1f}", speed.least / 1e6, speed.most / 1e6), row.steps_per_second(),
                     row.speed.bytes_per_cell, fmt::format("{:.0f} ({:.0f})", row.floor / 1e6, floor_bytes(row.which)),
                     row.percent(), fmt::format("{} + {}", row.operations.simple, row.operations.divided),
                     row.arithmetic_floor / 1e6, row.percent_of_arithmetic());
  if (row.speed.moving < 1.0) {
    out << fmt::format("  only {:.2f} % of the cells moved to the end\n", 100.0 * row.speed.moving);
  }
  out << std::flush;
}

void print_frame(std::ostream& out, const FrameRow& row) {
  out << fmt::format("frame of {0} x {0} cells, {1}, {2}: {3} ({4} to {5}) more than a step of {6}\n", row.size,
                     scheme_name(row.which), precision_name(row.which.precision), format_duration(row.cost.overhead()),
                     format_duration(row.cost.with_frame.least - row.cost.step.median),
                     format_duration(row.cost.with_frame.most - row.cost.step.median),
                     format_duration(row.cost.step.median));
}

void print_ensemble(std::ostream& out, const EnsembleRow& row) {
  out << fmt::format("{} runs of {} x {} cells side by side, {}, {}: {:.4g} steps/s ({:.4g} to {:.4g})\n", row.runs,
                     row.size, row.size, scheme_name(row.which), precision_name(row.which.precision),
                     row.steps_per_second.median, row.steps_per_second.least, row.steps_per_second.most);
}

void print_start(std::ostream& out, const StartRow& row) {
  out << fmt::format("solver start to first step, {} x {} cells: {} ({} to {})\n", row.columns, row.rows,
                     format_duration(row.seconds.median), format_duration(row.seconds.least),
                     format_duration(row.seconds.most));
}

std::string bench_json(const BenchReport& report) {
  JsonWriter json;
  const bool cuda = report.device.device == Device::cuda;
  json.begin_object().member("version", version()).member("commit", commit());
  json.member("device", cuda ? "cuda" : "cpu").member("name", report.device.name);
  json.member("details", report.device.details).member("processor", processor_name());
  json.member("threads", report.device.threads).member("vector_instructions", vector_instructions());
  json.member("repeats", report.repeats);
  add_measurement(json, "copy_bytes_per_second", report.bandwidth);
  json.member("copy_array_bytes", report.array_bytes);
  json.begin_array("arithmetic");
  for (const auto& [precision, rate] : report.rates) {
    add_rate(json, precision, rate);
  }
  const auto add_all = [&json](const char* key, const auto& rows, const auto& add) {
    json.end_array().begin_array(key);
    for (const auto& row : rows) {
      add(json, row);
    }
  };
  add_all("steps", report.steps, add_step);
  add_all("frames", report.frames, add_frame);
  add_all("ensembles", report.ensembles, add_ensemble);
  add_all("start_to_first_step", report.starts, add_start);
  return json.end_array().end_object().text();
}

}  // namespace sandsim::cli
