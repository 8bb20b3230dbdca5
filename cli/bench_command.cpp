#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <utility>
#include <vector>

#include "cli/bench_report.hpp"
#include "cli/commands.hpp"
#include "cli/copy_bandwidth.hpp"
#include "cli/machine.hpp"
#include "cli/text.hpp"
#include "solver/errors.hpp"

namespace sandsim::cli {

namespace {

/// How much is measured, from the options.
struct Effort {
  std::vector<int> sizes;
  int repeats = 0;
  int few_repeats = 0;      // of what is quickly measured
  double step_share = 1.0;  // of the steps that a measurement takes
  std::vector<Precision> precisions;
};

std::vector<int> sizes_of(const BenchArguments& arguments) {
  const bool cuda = arguments.device == Device::cuda;
  const int largest = !arguments.quick ? 32768 : cuda ? 1024 : 256;
  if (arguments.size) {
    return {std::min(*arguments.size, largest)};
  }
  if (!cuda) {
    return {std::min(2048, largest)};
  }
  std::vector<int> sizes;
  for (int size = 64; size <= std::min(16384, largest); size *= arguments.quick ? 4 : 2) {
    sizes.push_back(size);
  }
  return sizes;
}

Effort effort_of(const BenchArguments& arguments) {
  Effort effort;
  effort.sizes = sizes_of(arguments);
  effort.repeats = arguments.quick ? std::min(arguments.repeats, 2) : arguments.repeats;
  effort.few_repeats = std::max(effort.repeats, 3);
  effort.step_share = arguments.quick ? 0.1 : 1.0;
  if (arguments.precision != "float64") {
    effort.precisions.push_back(Precision::float32);
  }
  if (arguments.precision != "float32") {
    effort.precisions.push_back(Precision::float64);
  }
  return effort;
}

std::size_t array_bytes_of(const BenchArguments& arguments) {
  if (arguments.device == Device::cpu) {
    return copy_array_bytes(arguments.quick);
  }
  return std::size_t{arguments.quick ? 256u : 1024u} << 20;  // the largest cache of a card has some 100 MiB
}

/// The bench of one device, section by section. Prints as it goes unless the numbers are wanted as JSON.
class Bench {
 public:
  Bench(BenchDevice device, Effort effort, std::size_t array_bytes, std::ostream* table)
      : effort_(std::move(effort)), table_(table) {
    report_.device = std::move(device);
    report_.repeats = effort_.repeats;
    report_.array_bytes = array_bytes;
  }

  void measure_floors();
  void measure_steps();
  void measure_frames();
  void measure_ensembles();
  void measure_starts();
  const BenchReport& report() const { return report_; }

 private:
  template <class Print, class... Values>
  void show(const Print& print, const Values&... values) {
    if (table_ != nullptr) {
      print(*table_, values...);
    }
  }
  void measure_size(Precision precision, int size);
  void add_step(StepRow row) {
    show(print_step, row);
    report_.steps.push_back(std::move(row));
  }

  Effort effort_;
  std::ostream* table_;
  BenchReport report_;
};

void Bench::measure_floors() {
  report_.bandwidth = report_.device.copy_bandwidth(report_.array_bytes, effort_.few_repeats);
  show(print_head, report_);
  for (const Precision precision : effort_.precisions) {
    report_.rates[precision] = report_.device.arithmetic(precision, effort_.few_repeats);
    show(print_rate, precision, report_.rates[precision]);
  }
}

/// The slower kind of operation alone: the faster one runs beside it.
double arithmetic_floor(const OperationCount& count, const ArithmeticRate& rate) {
  return 1.0 / std::max(count.simple / rate.simple.median, count.divided / rate.divided.median);
}

void Bench::measure_size(Precision precision, int size) {
  const double needed = bench_host_bytes(precision, size), available = available_memory();
  const bool fits = available == 0.0 || needed < available;
  const StateArrays moving = fits ? moving_state(precision, size) : StateArrays{};
  for (const StepCase& which : step_cases(precision)) {
    StepRow row;
    row.which = which, row.size = size;
    const double steps = effort_.step_share * report_.device.steps_at_once / (1.0 * size * size);
    row.steps = static_cast<int>(std::clamp(steps, 2.0, 400.0));
    row.floor = report_.bandwidth.median / floor_bytes(which);
    row.operations = count_operations(which.scheme == Scheme::paper, which.order, !which.terrain);
    row.arithmetic_floor = arithmetic_floor(row.operations, report_.rates[precision]);
    if (!fits) {
      row.skipped = fmt::format("the host needs {} of memory, and {} are available", format_bytes(needed),
                                format_bytes(available));
      add_step(std::move(row));
      continue;
    }
    try {
      row.speed =
          measure_step(report_.device.make, which, size, moving, report_.device.threads, effort_.repeats, row.steps);
    } catch (const DeviceError& error) {  // too little of its memory
      row.skipped = error.what();
    }
    add_step(std::move(row));
  }
}

void Bench::measure_steps() {
  show(print_columns, report_);
  for (const int size : effort_.sizes) {
    for (const Precision precision : effort_.precisions) {
      measure_size(precision, size);
    }
  }
}

void Bench::measure_frames() {
  constexpr int size = 256;
  for (const Precision precision : effort_.precisions) {
    const StepCase which{Scheme::balanced, 2, precision, false};
    report_.frames.push_back(
        {which, size, measure_frame(report_.device.make, which, size, report_.device.threads, effort_.few_repeats)});
    show(print_frame, report_.frames.back());
  }
}

/// The small runs of a sweep, where the device takes many in a launch.
void Bench::measure_ensembles() {
  if (!report_.device.make_ensemble) {
    return;
  }
  constexpr int size = 64;
  for (const int runs : {1, 1000}) {
    for (const Scheme scheme : {Scheme::paper, Scheme::balanced}) {
      const StepCase which{scheme, 2, effort_.precisions.front(), false};
      report_.ensembles.push_back(
          {which, size, runs, measure_ensemble(report_.device.make_ensemble, which, size, runs, effort_.few_repeats)});
      show(print_ensemble, report_.ensembles.back());
    }
  }
}

void Bench::measure_starts() {
  for (const auto& [columns, rows] : {std::pair(160, 1), std::pair(512, 512)}) {
    report_.starts.push_back(
        {columns, rows,
         measure_start(report_.device.device, columns, rows, report_.device.threads, effort_.few_repeats)});
    show(print_start, report_.starts.back());
  }
}

}  // namespace

ExitCode bench_command(const BenchArguments& arguments, Console& console) {
  BenchDevice device = arguments.device == Device::cuda
                           ? cuda_bench_device()
                           : cpu_bench_device(arguments.threads > 0 ? arguments.threads : default_threads());
  Bench bench(std::move(device), effort_of(arguments), array_bytes_of(arguments),
              arguments.json ? nullptr : &console.out);
  bench.measure_floors();
  bench.measure_steps();
  if (!arguments.json) {
    console.out << '\n';
  }
  bench.measure_frames();
  bench.measure_ensembles();
  bench.measure_starts();
  if (arguments.json) {
    console.out << bench_json(bench.report());
  }
  return ExitCode::done;
}

}  // namespace sandsim::cli
