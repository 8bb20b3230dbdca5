// What the bench has measured: as a table that grows while it measures, and as JSON.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

#include "cli/bench_device.hpp"
#include "cli/operation_count.hpp"

namespace sandsim::cli {

/// The steps of one kind on size x size cells, against what memory and arithmetic allow.
struct StepRow {
  StepCase which;
  int size = 0;
  int steps = 0;        // a repeat
  std::string skipped;  // why nothing was measured, if nothing was
  StepSpeed speed;
  double floor = 0.0;  // [cell-steps/s] that the memory allows
  OperationCount operations;
  double arithmetic_floor = 0.0;  // [cell-steps/s] that the arithmetic allows

  double percent() const { return 100.0 * speed.cell_steps_per_second.median / floor; }
  double percent_of_arithmetic() const { return 100.0 * speed.cell_steps_per_second.median / arithmetic_floor; }
  double steps_per_second() const { return speed.cell_steps_per_second.median / (1.0 * size * size); }
};

struct FrameRow {
  StepCase which;
  int size = 0;
  FrameCost cost;
};

struct EnsembleRow {
  StepCase which;
  int size = 0;
  int runs = 0;
  Measurement steps_per_second;  // of all runs together
};

struct StartRow {
  int columns = 0;
  int rows = 0;
  Measurement seconds;
};

/// The sections of the bench in the order of the table.
struct BenchReport {
  BenchDevice device;
  int repeats = 0;
  std::size_t array_bytes = 0;
  Measurement bandwidth;
  std::map<Precision, ArithmeticRate> rates;
  std::vector<StepRow> steps;
  std::vector<FrameRow> frames;
  std::vector<EnsembleRow> ensembles;
  std::vector<StartRow> starts;
};

void print_head(std::ostream& out, const BenchReport& report);
void print_rate(std::ostream& out, Precision precision, const ArithmeticRate& rate);
void print_columns(std::ostream& out, const BenchReport& report);
void print_step(std::ostream& out, const StepRow& row);
void print_frame(std::ostream& out, const FrameRow& row);
void print_ensemble(std::ostream& out, const EnsembleRow& row);
void print_start(std::ostream& out, const StartRow& row);

std::string bench_json(const BenchReport& report);

}  // namespace sandsim::cli
