#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <set>
#include <utility>
#include <vector>

#include "cli/commands.hpp"
#include "cli/machine.hpp"
#include "cli/run_paths.hpp"
#include "cli/stress/isolated_jobs.hpp"
#include "cli/stress/matrix.hpp"
#include "cli/stress/measure.hpp"
#include "cli/stress/stress_files.hpp"
#include "cli/stress/stress_table.hpp"
#include "cli/text.hpp"
#include "io/output/atomic_file.hpp"
#include "io/output/version.hpp"
#include "io/scene/scene_reader.hpp"
#include "solver/backends/cuda/cuda.hpp"
#include "solver/errors.hpp"

namespace sandsim::cli {

namespace fs = std::filesystem;

namespace {

/// [s] for a run of the built-in matrix, the longest of which takes about one.
constexpr double default_limit = 30.0;

/// Cases with the files of their scenes.
struct Batch {
  std::vector<StressCase> cases;
  std::vector<fs::path> scenes;
};

/// The device's name. It is looked for in a child process: what has opened a CUDA device cannot be forked any more.
std::string find_device(Device device) {
  if (device == Device::cpu) {
    return "cpu";
  }
  JobEnd found;
  run_isolated(
      1, 1, 120.0, [](std::size_t) { return survey_cuda().problem; },
      [&](std::size_t, const JobEnd& end) { found = end; });
  const std::string problem = found.problem.empty() ? found.result : found.problem;
  if (!problem.empty()) {
    throw DeviceError("--device cuda: " + problem);
  }
  return "cuda";
}

Batch own_cases(std::vector<StressCase> cases, const StressArguments& arguments, const StressFiles& files) {
  if (arguments.quick) {
    cases = quick_part(std::move(cases));
  }
  std::erase_if(cases, [&](const StressCase& each) { return each.name.find(arguments.only) == std::string::npos; });
  Batch batch{std::move(cases), {}};
  for (const StressCase& its : batch.cases) {
    batch.scenes.push_back(write_case(its, files.scenes));
  }
  return batch;
}

/// The scenes of the command line; those with the same name are numbered.
Batch given_cases(const std::vector<std::string>& scenes) {
  Batch batch;
  std::set<std::string> names;
  for (const std::string& given : scenes) {
    StressCase its{default_output_directory(scene_file(given)).filename().string(), given, {}};
    const std::string name = its.name;
    for (int k = 2; !names.insert(its.name).second; ++k) {
      its.name = fmt::format("{}_{}", name, k);
    }
    its.theme = "given";
    batch.cases.push_back(its);
    batch.scenes.push_back(scene_file(given));
    read_scene(batch.scenes.back());  // a scene that is none is no finding
  }
  return batch;
}

std::vector<Trial> trials_of(const Batch& batch) {
  std::vector<Trial> trials;
  for (std::size_t k = 0; k < batch.cases.size(); ++k) {
    for (const Variant& variant : all_variants()) {
      trials.push_back({batch.scenes[k], variant, batch.cases[k].criteria, batch.cases[k].step_in_bounds});
    }
  }
  return trials;
}

class Stress {
 public:
  Stress(const StressArguments& arguments, Console& console)
      : arguments_(arguments),
        console_(console),
        device_(find_device(arguments.device)),
        files_(prepare_stress_directory(arguments.output, arguments.overwrite)) {}

  ExitCode run();

 private:
  StressTable run_batch(const Batch& batch, const char* name);
  void write_failures(const StressTable& table, const std::vector<Trial>& trials, bool known_too);
  void write_tables(const StressTable& matrix, const StressTable& maps);

  const StressArguments& arguments_;
  Console& console_;
  std::string device_;
  StressFiles files_;
};

StressTable Stress::run_batch(const Batch& batch, const char* name) {
  const std::vector<Trial> trials = trials_of(batch);
  const bool is_given = !arguments_.scenes.empty();
  MeasureOptions options;
  options.device = arguments_.device;
  options.max_wall = arguments_.max_wall > 0.0 ? arguments_.max_wall : is_given ? 0.0 : default_limit;
  // A run looks at its limit between steps; one that does not come back is killed. Every scene is run twice.
  const double patience = options.max_wall > 0.0 ? 2.0 * options.max_wall + 30.0 : 1e9;
  const int jobs = arguments_.jobs > 0 ? arguments_.jobs : arguments_.device == Device::cuda ? 1 : default_threads();
  StressTable table{batch.cases, std::vector<StressRow>(trials.size()), device_};
  std::size_t done = 0;
  const auto take = [&](std::size_t k, const JobEnd& end) {
    StressRow& row = table.rows[k];
    row.index = k / all_variants().size();
    row.variant = trials[k].variant;
    if (end.problem.empty()) {
      row.measured = Measurement::decode(end.result);
      row.findings = judge(row.measured, trials[k].criteria, row.variant.precision);
    } else {
      row.measured.exit_code = -1;
      row.measured.message = end.problem;
      row.findings = {{"ending", end.problem}};
    }
    row.is_known = !row.passed() && row.variant.order == 0 && !table.cases[row.index].paper.empty();
    if (console_.terminal) {
      console_.err << fmt::format("\r{}: {} of {} runs", name, ++done, trials.size()) << std::flush;
    }
  };
  run_isolated(
      trials.size(), jobs, patience, [&](std::size_t k) { return measure(trials[k], options).encode(); }, take);
  if (console_.terminal) {
    console_.err << '\n';
  }
  write_failures(table, trials, batch.cases.empty() || !batch.cases.front().place);
  return table;
}

void Stress::write_failures(const StressTable& table, const std::vector<Trial>& trials, bool known_too) {
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    const StressRow& row = table.rows[k];
    if (!row.passed() && (known_too || !row.is_known)) {
      write_failure(row, table.cases[row.index], trials[k], files_);
    }
  }
}

void Stress::write_tables(const StressTable& matrix, const StressTable& maps) {
  std::string text = fmt::format("{}, {}\n\n    {}\n\nCases that passed:\n\n{}\n", source_line(), device_,
                                 arguments_.command_line, count_markdown(matrix));
  if (!maps.cases.empty()) {
    text += fmt::format("Cells of the stability maps that passed:\n\n{}\n", count_markdown(maps));
    write_file_atomically(files_.maps, maps_csv(maps));
  }
  text += stress_markdown(matrix);
  write_file_atomically(files_.markdown, text);
  write_file_atomically(files_.csv, stress_csv(matrix));
}

ExitCode Stress::run() {
  const bool is_given = !arguments_.scenes.empty();
  const Batch cases =
      is_given ? given_cases(arguments_.scenes) : own_cases(stress_matrix(arguments_.randoms), arguments_, files_);
  const Batch cells = is_given ? Batch{} : own_cases(stability_maps(), arguments_, files_);
  if (cases.cases.empty() && cells.cases.empty()) {
    throw Error(ExitCode::usage, "--only " + arguments_.only + ": no case has this in its name");
  }
  const StressTable matrix = run_batch(cases, "cases");
  const StressTable maps = run_batch(cells, "map cells");
  write_tables(matrix, maps);
  print_counts(console_.out, matrix, "cases");
  if (!maps.cases.empty()) {
    print_counts(console_.out, maps, "map cells");
  }
  print_failures(console_.out, matrix);
  print_failures(console_.out, maps);
  console_.out << files_.directory.string() << ": stress.csv, stress.md" << (maps.cases.empty() ? "" : ", maps.csv")
               << ", scenes, failures\n";
  return matrix.passed() && maps.passed() ? ExitCode::done : ExitCode::numerical_failure;
}

}  // namespace

ExitCode stress_command(const StressArguments& arguments, Console& console) {
  return Stress(arguments, console).run();
}

}  // namespace sandsim::cli
