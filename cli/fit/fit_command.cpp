#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <ostream>

#include "cli/commands.hpp"
#include "cli/fit/findings.hpp"
#include "cli/machine.hpp"
#include "cli/memory.hpp"
#include "cli/option_value.hpp"
#include "cli/run_paths.hpp"
#include "cli/signals.hpp"
#include "cli/text.hpp"
#include "io/output/atomic_file.hpp"
#include "io/output/mesh_cache.hpp"
#include "io/scene/scene_reader.hpp"
#include "solver/errors.hpp"

namespace sandsim::cli {

namespace fs = std::filesystem;

namespace {

using Clock = std::chrono::steady_clock;

constexpr double known_to = 0.01;  // of the signal: how well data are known, unless the user says so
// How well a front is known on a grid, in cells: between cell centres the depth is linear, the last wet cell is whole.
constexpr double front_cells = 0.1, tip_cells = 1.0;
constexpr double long_fit = 3600.0;  // [s] above which --yes is needed
constexpr int many_runs = 1000;      // likewise

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

struct FitFiles {
  explicit FitFiles(const fs::path& folder)
      : directory(folder), report(folder / "fit.yaml"), runs(folder / "fit.csv"), map(folder / "map.csv") {}

  fs::path directory, report, runs, map;
};

/// Refuses a directory that is not empty, unless `overwrite` is set, which removes the files of an earlier fit.
FitFiles prepare_directory(const fs::path& directory, bool overwrite) {
  const FitFiles files(directory);
  std::error_code error;
  fs::create_directories(directory, error);
  if (error || !fs::is_directory(directory)) {
    throw OutputError(fmt::format("{}: cannot be made: {}", directory.string(), error.message()));
  }
  if (!overwrite && !fs::is_empty(directory, error)) {
    throw OutputError(
        fmt::format("{}: is not empty\n  choose another directory with -o, or --overwrite it", directory.string()));
  }
  for (const fs::path& file : {files.report, files.runs, files.map}) {
    fs::remove(file, error);
  }
  return files;
}

fs::path directory_of(const FitArguments& arguments) {
  return arguments.output.empty() ? fs::path(default_output_directory(scene_file(arguments.scene)).string() + "_fit")
                                  : fs::path(arguments.output);
}

struct Tolerance {
  double value = 0.0;  // [m]
  std::string reason;
};

Tolerance tolerance_of(const FitArguments& arguments, const FitReference& reference, const Scene& scene) {
  if (arguments.tolerance) {
    const std::string& text = *arguments.tolerance;
    const double value = positive_option("--tolerance", text, Dimension::length, scene.grid.spacing);
    return {value, "the best and --tolerance " + text};
  }
  const double cells = reference.front_depth > 0.0 ? front_cells : tip_cells;
  const double of_signal = known_to * reference.signal, of_cell = cells * scene.grid.spacing;
  if (reference.kind == FitReference::Kind::front && of_cell > of_signal) {
    return {of_cell, fmt::format("the best and {:g} times the cell's side", cells)};
  }
  return {of_signal, fmt::format("the best and {:g} % of the {}", 100.0 * known_to, reference.signal_name())};
}

/// Says on standard error how far the fit is.
class FitProgress {
 public:
  FitProgress(const FitArguments& arguments, Console& console) : arguments_(arguments), console_(console) {}
  ~FitProgress() { wipe(); }
  FitProgress(const FitProgress&) = delete;
  FitProgress& operator=(const FitProgress&) = delete;

  void update(const Evaluation& evaluation) {
    ++runs_;
    best_ = evaluation.failed() ? best_ : std::fmin(best_, evaluation.misfit);
    if (console_.terminal && !arguments_.quiet && Clock::now() >= next_) {
      next_ = Clock::now() + std::chrono::milliseconds(200);
      drawn_ = true;
      console_.err << fmt::format("\r\033[Kfit: {} runs, best misfit {:.3g} m", runs_, best_) << std::flush;
    }
  }
  void say(const std::string& message) {
    wipe();
    if (!arguments_.quiet) {
      console_.err << "sandsim: " << message << '\n';
    }
  }
  void wipe() {
    if (drawn_) {
      console_.err << "\r\033[K" << std::flush;
    }
    drawn_ = false;
  }

 private:
  const FitArguments& arguments_;
  Console& console_;
  int runs_ = 0;
  double best_ = std::nan("");
  bool drawn_ = false;
  Clock::time_point next_{};
};

int evaluations_of(const FitArguments& arguments, std::size_t parameters) {
  constexpr int for_each_parameter = 60;
  return arguments.evaluations > 0 ? arguments.evaluations : for_each_parameter * static_cast<int>(parameters);
}

/// Runs that a fit takes, roughly: the ends of a range take some eight looks of a few runs each.
double expected_runs(const FitArguments& arguments, std::size_t parameters) {
  const double map = parameters == 1 ? 3.0 * arguments.map : std::pow(arguments.map, 2);
  return evaluations_of(arguments, parameters) + map +
         2.0 * static_cast<double>(parameters * (4 + 16 * (parameters - 1)));
}

void require_patience(const FitArguments& arguments, std::size_t parameters, double seconds_per_run, int parallel) {
  const double runs = expected_runs(arguments, parameters);
  const double seconds = runs * seconds_per_run / parallel;
  if (arguments.yes || (runs <= many_runs && seconds <= long_fit)) {
    return;
  }
  throw Error(
      ExitCode::usage,
      fmt::format("fit: about {:.0f} runs, {} in all. A coarser grid, fewer --evaluations or a smaller --map make "
                  "it shorter; if that is meant, say --yes.",
                  runs, format_duration(seconds)));
}

/// A fit that is ready to be searched.
class Fit {
 public:
  Fit(const FitArguments& arguments, Console& console)
      : arguments_(arguments),
        console_(console),
        parameters_(read_fit_parameters(arguments.vary, arguments.overrides)),
        base_{scene_file(arguments.scene), arguments.overrides, keys_of(parameters_), {}, {}} {
    require_valid_bounds(base_, parameters_);
    std::vector<std::string> warnings;
    scene_ = read_scene(base_.scene, overrides_of_scene(), &warnings);
    require_memory(scene_);
    reference_ = read_fit_reference(arguments, scene_);
    tolerance_ = tolerance_of(arguments, reference_, scene_);
    warnings.insert(warnings.end(), reference_.warnings.begin(), reference_.warnings.end());
    for (const std::string& warning : warnings) {
      if (!arguments.quiet) {
        console.err << "sandsim: warning: " << warning << '\n';
      }
    }
  }

  ExitCode run() {
    require_patience(arguments_, parameters_.size(), 0.0, 1);
    const SignalGuard signals;
    const FitFiles files = prepare_directory(directory_of(arguments_), arguments_.overwrite);
    bake_meshes(scene_, files.directory);  // once, before runs side by side look for them
    Evaluator evaluator(base_, parameters_, reference_, files.directory, signals.interrupted());
    FitProgress progress(arguments_, console_);
    evaluator.observe([&progress](const Evaluation& one) { progress.update(one); });
    try {
      search(evaluator, progress, files);
      return ExitCode::done;
    } catch (const FitInterrupted&) {
      write_runs(evaluator.log(), files);
      progress.say(fmt::format("interrupted by {}; {} has the runs so far", signals.name(), files.runs.string()));
      return ExitCode::interrupted;
    } catch (const Error&) {
      write_runs(evaluator.log(), files);
      throw;
    }
  }

 private:
  static std::vector<std::string> keys_of(const std::vector<FitParameter>& parameters) {
    std::vector<std::string> keys;
    for (const FitParameter& parameter : parameters) {
      keys.push_back(parameter.key);
    }
    return keys;
  }

  /// The scene's own values; a key that it leaves to the fit has one in the middle.
  std::vector<std::string> overrides_of_scene() const {
    try {
      read_scene(base_.scene, base_.overrides);
      return base_.overrides;
    } catch (const SceneError&) {
      SweepCase middle;
      middle.values = values_at(parameters_, FitPoint(parameters_.size(), 0.5));
      return base_.overrides_of(middle);
    }
  }

  void write_runs(const std::vector<Evaluation>& evaluations, const FitFiles& files) const {
    write_file_atomically(files.runs, csv_text(fit_table(parameters_, evaluations, reference_)));
  }

  void search(Evaluator& evaluator, FitProgress& progress, const FitFiles& files) const {
    const auto begin = Clock::now();
    const int parallel = arguments_.parallel > 0 ? arguments_.parallel : default_threads();
    FitSearch search(evaluator, {evaluations_of(arguments_, parameters_.size()), parallel, arguments_.map,
                                 arguments_.seed, tolerance_.value});
    search.start();
    require_patience(arguments_, parameters_.size(), search.seconds_per_run(), parallel);
    const FitResult result = search.finish();
    const FitReport report{
        parameters_,       reference_,          result, base_.scene.string(), arguments_.command_line,
        tolerance_.reason, seconds_since(begin)};
    write_runs(result.evaluated, files);
    if (!result.map.empty()) {
      write_file_atomically(files.map, csv_text(fit_table(parameters_, result.map, reference_)));
    }
    write_file_atomically(files.report, fit_yaml(report));
    progress.wipe();
    if (!arguments_.quiet) {
      console_.out << fit_summary(report)
                   << fmt::format("  {}: fit.yaml, fit.csv{}\n", files.directory.string(),
                                  result.map.empty() ? "" : ", map.csv");
    }
  }

  const FitArguments& arguments_;
  Console& console_;
  std::vector<FitParameter> parameters_;
  Sweep base_;
  Scene scene_;
  FitReference reference_;
  Tolerance tolerance_;
};

}  // namespace

ExitCode fit_command(const FitArguments& arguments, Console& console) {
  return Fit(arguments, console).run();
}

}  // namespace sandsim::cli
