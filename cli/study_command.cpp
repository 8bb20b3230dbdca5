#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <ostream>
#include <utility>

#include "cli/commands.hpp"
#include "cli/machine.hpp"
#include "cli/memory.hpp"
#include "cli/signals.hpp"
#include "cli/study/tables.hpp"
#include "cli/text.hpp"
#include "io/output/atomic_file.hpp"
#include "io/output/mesh_cache.hpp"
#include "io/output/output_directory.hpp"
#include "io/output/run_report.hpp"
#include "io/study/study_reader.hpp"
#include "solver/errors.hpp"

namespace sandsim::cli {

namespace fs = std::filesystem;

namespace {

fs::path study_file(const std::string& given) {
  std::error_code ignored;  // whoever opens the file reports what is wrong with it
  return fs::is_directory(given, ignored) ? fs::path(given) / "study.yaml" : fs::path(given);
}

fs::path default_directory(const fs::path& file) {
  const std::string stem = file.stem().string();
  const std::string folder = fs::absolute(file).lexically_normal().parent_path().filename().string();
  return fs::path("results") / ("study_" + (stem == "study" && !folder.empty() ? folder : stem));
}

/// What the options change in a study.
void apply(const StudyArguments& arguments, Study& study) {
  if (arguments.quick) {
    study.repeats = 1;
    std::sort(study.spacings.begin(), study.spacings.end(), std::greater<>());
    study.spacings.resize(std::min<std::size_t>(study.spacings.size(), 3));
  }
  if (arguments.repeats) {
    study.repeats = *arguments.repeats;
  }
  if (arguments.shortest) {
    study.times = TimeChoice::shortest;
  }
  if (!arguments.under.empty()) {
    study.under = arguments.under;
  }
}

/// One study, from its plan to its files.
class StudySession {
 public:
  StudySession(const StudyArguments& arguments, StudyPlan plan, fs::path directory, Console& console);
  ExitCode run();

 private:
  void prepare(Scene& scene);
  void make_fine_runs();
  using Results = std::vector<TimedResult>;
  Results measure(const std::vector<TimedJob>& jobs, const std::vector<std::string>& names,
                  const std::function<void(const Results&)>& after_round);
  void write_rows(const StudyFindings& findings) const;
  Results measure_cases();
  Results measure_variants();
  void remark_on(const StudyFindings& findings);
  ExitCode write(const Results& cases, const Results& variants);
  void say(const std::string& message) const;

  const StudyArguments& arguments_;
  StudyPlan plan_;
  fs::path directory_;
  Console& console_;
  SignalGuard signals_;
  RoundOptions rounds_;
  StudySetting setting_;
  std::vector<FineDepth> fine_;
};

StudySession::StudySession(const StudyArguments& arguments, StudyPlan plan, fs::path directory, Console& console)
    : arguments_(arguments), plan_(std::move(plan)), directory_(std::move(directory)), console_(console) {
  rounds_.repeats = setting_.repeats = plan_.study.repeats;
  rounds_.scratch = directory_;
  rounds_.interrupt = &signals_.interrupted();
  setting_.processors = processor_count();
  setting_.machine = fmt::format("{}, {}", processor_name(), vector_instructions());
  setting_.date = time_stamp();
  setting_.load_before = load_average();
}

void StudySession::say(const std::string& message) const {
  if (!arguments_.quiet) {
    console_.err << "sandsim: " << message << '\n' << std::flush;
  }
}

void StudySession::prepare(Scene& scene) {
  require_memory(scene);
  bake_meshes(scene, fs::absolute(directory_).parent_path());
}

void StudySession::make_fine_runs() {
  for (StudyRun& run : plan_.fine) {
    prepare(run.setup);
    const FineDepth& fine = fine_.emplace_back(fine_depth(run, fs::absolute(directory_).parent_path(), rounds_));
    say(fine.is_from_file ? fmt::format("fine run of '{}': taken from {}", run.name, fine.file.string())
                          : fmt::format("fine run of '{}': {}, kept in {}", run.name, format_duration(fine.seconds),
                                        fine.file.string()));
  }
}

StudySession::Results StudySession::measure(const std::vector<TimedJob>& jobs, const std::vector<std::string>& names,
                                            const std::function<void(const Results&)>& after_round) {
  if (console_.terminal && !arguments_.quiet) {
    rounds_.progress = [&](int round, std::size_t k) {
      const std::string what = round == 0 ? "warm-up" : fmt::format("round {} of {}", round, rounds_.repeats);
      console_.err << fmt::format("\r\033[K{}, setting {} of {}: {:.50}", what, k + 1, jobs.size(), names[k])
                   << std::flush;
    };
  }
  Results results = run_rounds(jobs, rounds_, after_round);
  if (rounds_.progress) {
    console_.err << "\r\033[K" << std::flush;
  }
  return results;
}

StudySession::Results StudySession::measure_cases() {
  std::vector<TimedJob> jobs;
  std::vector<std::string> names;
  for (StudyCase& setting : plan_.cases) {
    prepare(setting.setup);
    const Device device = choose_device(setting.device, setting.setup.grid).device;
    jobs.push_back({&setting.setup, device, setting.threads, false});
    names.push_back(plan_.study.scenes[setting.scene].name + ", " + setting.method);
  }
  // A study may take long: what is known after a round survives whatever ends it.
  return measure(jobs, names, [this](const Results& results) { write_rows(analyse(plan_, results, fine_)); });
}

StudySession::Results StudySession::measure_variants() {
  std::vector<TimedJob> jobs;
  std::vector<std::string> names;
  for (StudyRun& variant : plan_.variants) {
    prepare(variant.setup);
    const Device device = choose_device(plan_.study.devices.front(), variant.setup.grid).device;
    jobs.push_back({&variant.setup, device, plan_.study.threads.front(), plan_.study.ablation->writes});
    names.push_back(variant.name);
  }
  return measure(jobs, names, {});
}

/// What the numbers cannot say, and settings without them.
void StudySession::remark_on(const StudyFindings& findings) {
  std::vector<std::string>& remarks = setting_.remarks;
  // A study keeps one processor busy, and so did the one before; half of one more is what a desktop does on the side.
  if (setting_.load_before > std::max(0.5, setting_.processors - 0.5)) {
    remarks.push_back("The machine was busy with something else: the times are not to be trusted.");
  }
  const bool any_order = std::any_of(findings.points.begin(), findings.points.end(),
                                     [](const StudyPoint& point) { return point.order.has_value(); });
  if (!findings.points.empty() && !any_order) {
    remarks.push_back("No order can be observed: that takes two spacings with errors above zero.");
  }
  for (std::size_t scene = 0; scene < plan_.study.scenes.size(); ++scene) {
    const auto count = std::count_if(findings.points.begin(), findings.points.end(), [&](const StudyPoint& point) {
      return point.setting->scene == scene && point.seconds && std::isfinite(point.error);
    });
    if (count < 2) {
      remarks.push_back(fmt::format("No frontier of '{}': that takes two settings with an error and a time.",
                                    plan_.study.scenes[scene].name));
    }
  }
  std::vector<std::string> notes;
  for (const StudyPoint& point : findings.points) {
    if (!point.note.empty() && std::find(notes.begin(), notes.end(), point.note) == notes.end()) {
      notes.push_back(point.note);
      remarks.push_back(fmt::format("No error of '{}' at a spacing of {:g} m{}: {}.",
                                    plan_.study.scenes[point.setting->scene].name, point.setting->setup.grid.spacing,
                                    point.setting->method.empty() ? "" : " with " + point.setting->method, point.note));
    }
  }
}

void StudySession::write_rows(const StudyFindings& findings) const {
  if (!findings.points.empty()) {
    write_file_atomically(directory_ / "study.csv", study_csv(plan_, findings));
  }
}

ExitCode StudySession::write(const Results& cases, const Results& variants) {
  setting_.load_after = load_average();
  const StudyFindings findings = analyse(plan_, cases, fine_);
  const std::vector<AblationRow> ablation = compare_variants(plan_, variants);
  remark_on(findings);
  const std::string tables = study_markdown(plan_, findings, ablation, setting_);
  write_file_atomically(directory_ / "table.md", tables);
  write_rows(findings);
  if (!ablation.empty()) {
    write_file_atomically(directory_ / "ablation.csv", ablation_csv(ablation));
  }
  if (!arguments_.quiet) {
    console_.out << tables << "\nTables and numbers: " << directory_.string()
                 << "; scripts/plot draws them from there.\n";
  }
  const auto failed = [](const TimedResult& result) { return result.failed(); };
  for (const auto* results : {&cases, &variants}) {
    if (const auto found = std::find_if(results->begin(), results->end(), failed); found != results->end()) {
      console_.err << "sandsim: error: a setting failed, the others are there: " << found->report.message << '\n';
      return ExitCode::numerical_failure;
    }
  }
  return ExitCode::done;
}

ExitCode StudySession::run() {
  write_file_atomically(directory_ / "study.yaml", resolved_study(plan_.study));
  make_fine_runs();
  const std::vector<TimedResult> cases = measure_cases();
  const std::vector<TimedResult> variants = measure_variants();
  const bool interrupted = signals_.interrupted();
  if (interrupted) {
    setting_.remarks.push_back(fmt::format("Interrupted by {}: not every setting was run.", signals_.name()));
  }
  const ExitCode code = write(cases, variants);
  return interrupted ? ExitCode::interrupted : code;
}

/// The settings of a plan, without running any.
std::string listed(const StudyPlan& plan) {
  std::string text;
  for (const StudyCase& setting : plan.cases) {
    std::vector<std::string> parts{plan.study.scenes[setting.scene].name};
    if (!setting.method.empty()) {
      parts.push_back(setting.method);
    }
    parts.insert(parts.end(), setting.picks.begin(), setting.picks.end());
    const Grid& grid = setting.setup.grid;
    text += fmt::format("{}, {} x {} cells of {:g} m\n", join(", ", parts), grid.cells[0], grid.cells[1], grid.spacing);
  }
  for (const StudyRun& run : plan.fine) {
    text += fmt::format("{}, fine run, {} x {} cells\n", run.name, run.setup.grid.cells[0], run.setup.grid.cells[1]);
  }
  for (const StudyRun& variant : plan.variants) {
    text += fmt::format("ablation, {}\n", variant.name);
  }
  return text + fmt::format("{} settings, {} variants, {} repeats each after a warm-up\n", plan.cases.size(),
                            plan.variants.size(), plan.study.repeats);
}

}  // namespace

ExitCode study_command(const StudyArguments& arguments, Console& console) {
  const fs::path file = study_file(arguments.study);
  StudyPlan plan = read_study(file, [&](Study& study) { apply(arguments, study); });
  if (arguments.list) {
    console.out << listed(plan);
    return ExitCode::done;
  }
  for (const StudyCase& setting : plan.cases) {
    choose_device(setting.device, setting.setup.grid);  // throws before anything is run
  }
  const fs::path directory = arguments.output.empty() ? default_directory(file) : fs::path(arguments.output);
  prepare_output_directory(directory, arguments.overwrite, false);
  StudySession session(arguments, std::move(plan), directory, console);
  return session.run();
}

}  // namespace sandsim::cli
