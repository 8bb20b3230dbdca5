// Includes CLI11, as the other set-up of options does: it takes seconds to compile, and it would exit with codes of
// its own.
#include "cli/app.hpp"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <iostream>
#include <vector>

#include "cli/commands.hpp"
#include "cli/export/export_options.hpp"
#include "cli/failures.hpp"
#include "cli/help.hpp"
#include "cli/option_checks.hpp"
#include "cli/text.hpp"
#include "io/output/version.hpp"

namespace sandsim::cli {

namespace {

/// The options of every command, and the command that was chosen.
struct Arguments {
  RunArguments run;
  SweepArguments sweep;
  FitArguments fit;
  CheckArguments check;
  InfoArguments info;
  ExportArguments exported;
  SchemaArguments schema;
  BenchArguments bench;
  StudyArguments study;
  StressArguments stress;
  std::function<ExitCode(Console&)> command;
};

void add_scene(CLI::App& command, std::string& scene, std::vector<std::string>& overrides) {
  command.add_option("SCENE", scene, "Scene file, or a folder that holds a scene.yaml")->required();
  // One value each, or `--set a=1 scene.yaml` would take the scene for a second value.
  command.add_option("--set", overrides, "Override a value of the scene, as in 'time.end=2 s'; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

void add_precision(CLI::App& command, std::optional<std::string>& precision, const std::string& meaning) {
  command.add_option("--precision", precision, meaning)
      ->type_name("float32|float64")
      ->check(one_of({"float32", "float64"}));
}

void add_threads(CLI::App& command, int& threads, const std::string& by_default) {
  command.add_option("--threads", threads, "Threads; if absent, " + by_default + ". Results do not depend on it")
      ->type_name("N")
      ->check(CLI::Range(1, 4096));
}

void add_device(CLI::App& command, Device& device, const std::string& meaning,
                const std::string& type = "auto|cpu|cuda",
                const std::vector<std::string>& names = {"auto", "cpu", "cuda"}) {
  const auto choose = [&device](const std::string& name) {
    device = name == "cuda" ? Device::cuda : name == "cpu" ? Device::cpu : Device::automatic;
  };
  command.add_option_function<std::string>("--device", choose, meaning)->type_name(type)->check(one_of(names));
}

void add_wall_limit(CLI::App& command, double& limit, const std::string& meaning) {
  const auto read = [&limit](const std::string& text) {
    const std::optional<double> seconds = parse_wall_clock(text);
    if (!seconds) {
      throw CLI::ValidationError("--max-wall", "'" + text + "' is not HH:MM:SS, as in 01:30:00 for an hour and a half");
    }
    limit = *seconds;
  };
  command.add_option_function<std::string>("--max-wall", read, meaning)->type_name("HH:MM:SS");
}

void add_run(CLI::App& app, Arguments& all) {
  RunArguments& run = all.run;
  CLI::App& command = *app.add_subcommand("run", "Run a scene");
  add_scene(command, run.scene, run.overrides);
  command.add_option("-o,--output", run.output, "Output directory; results/NAME if absent (see below)")
      ->type_name("DIR");
  add_device(command, run.device, "auto takes the fastest there is; auto if absent");
  add_threads(command, run.threads, "as many as have a processor free and pay");
  add_precision(command, run.precision, "Override numerics.precision");
  CLI::Option* resume = command.add_flag("--resume", run.resume, "Go on from DIR's checkpoint.h5");
  command.add_flag("--overwrite", run.overwrite, "Remove the results of an earlier run from DIR")->excludes(resume);
  add_wall_limit(command, run.max_wall, "End after this much time, with a checkpoint");
  command.add_flag("--json", run.json, "Print the run report (run.json) instead of the summary");
  CLI::Option* quiet = command.add_flag("-q,--quiet", run.quiet, "No progress, summary or warnings; errors only");
  command.add_flag("-v,--verbose", run.verbose, "Say what is chosen and done, on standard error")->excludes(quiet);
  // Not for people: `sandsim sweep` follows its cases with it.
  command.add_option("--progress-fd", run.progress_fd)->group("");
  command.footer(help::run);
  command.callback([&all] { all.command = [&all](Console& console) { return run_command(all.run, console); }; });
}

void add_sweep_cases(CLI::App& command, SweepArguments& sweep) {
  command
      .add_option("SCENE", sweep.scene,
                  "Scene, sweep file, a folder that holds a sweep.yaml or scene.yaml, or the DIR of an earlier sweep")
      ->required();
  command.add_option("--vary", sweep.vary, "What varies: a list, a range or an interval (see below); may be repeated")
      ->type_name("KEY=VALUES")
      ->allow_extra_args(false);
  command.add_option("--set", sweep.overrides, "Override a value of the scene in all cases; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command.add_option("--samples", sweep.samples, "Number of samples drawn from the intervals")
      ->type_name("N")
      ->check(CLI::Range(1, 1'000'000));
  command.add_option("--sampling", sweep.sampling, "How: Latin hypercube or independent points; latin if absent")
      ->type_name("latin|random")
      ->check(one_of({"latin", "random"}));
  command.add_option("--seed", sweep.seed, "The same seed draws the same samples everywhere; 1 if absent")
      ->type_name("S");
}

void add_sweep_actions(CLI::App& command, SweepArguments& sweep) {
  CLI::Option* list = command.add_flag("--list", sweep.list, "Print the cases and how far they are; run nothing");
  CLI::Option* expand =
      command.add_flag("--expand", sweep.expand, "Write the numbered cases and a job script for Slurm; run nothing");
  CLI::Option* one =
      command.add_option("--case", sweep.one_case, "Run case N only")->type_name("N")->check(CLI::Range(1, 1'000'000));
  CLI::Option* collect =
      command.add_flag("--collect", sweep.collect, "Gather what the cases have left into the summary; run nothing");
  for (CLI::Option* option : {expand, one, collect}) {
    option->excludes(list);
  }
  for (CLI::Option* option : {one, collect}) {
    option->excludes(expand);
  }
  one->excludes(collect);
}

void add_sweep(CLI::App& app, Arguments& all) {
  SweepArguments& sweep = all.sweep;
  CLI::App& command = *app.add_subcommand("sweep", "Run a scene with different values, side by side");
  add_sweep_cases(command, sweep);
  command.add_option("-o,--output", sweep.output, "Output directory; results/NAME_sweep if absent")->type_name("DIR");
  command.add_option("-j,--jobs", sweep.parallel, "Cases at a time; one a processor if absent")
      ->type_name("N")
      ->check(CLI::Range(1, 4096));
  command.add_option("--threads", sweep.threads, "Threads of each case; 1 with -j, else shared out among the cases")
      ->type_name("N")
      ->check(CLI::Range(1, 4096));
  add_precision(command, sweep.precision, "Override numerics.precision in all cases");
  add_device(command, sweep.device, "As for run");
  add_wall_limit(command, sweep.max_wall, "End after this much time, the running cases with checkpoints");
  command.add_flag("--yes", sweep.yes, "Run more than 1000 cases");
  command.add_flag("--skip-invalid", sweep.skip_invalid, "Record cases that are no valid scene and run the others");
  command.add_flag("--retry", sweep.retry, "Run cases that broke down numerically once more");
  command.add_flag("--overwrite", sweep.overwrite, "Remove the results of another sweep from DIR");
  add_sweep_actions(command, sweep);
  command.add_flag("-q,--quiet", sweep.quiet, "No progress and no summary; errors only");
  command.footer(help::sweep);
  command.callback([&all] { all.command = [&all](Console& console) { return sweep_command(all.sweep, console); }; });
}

void add_fit_reference(CLI::App& command, FitArguments& fit) {
  CLI::Option* front = command.add_option("--front", fit.front, "Fit to a front over time (columns time_s,front_m)");
  front->type_name("FILE.csv");
  CLI::Option* profile = command.add_option("--profile", fit.profile, "Fit to a profile (columns x_m,depth_m)");
  profile->type_name("FILE.csv")->excludes(front);
  command.add_option("--run", fit.run, "Fit to the front of another run, or with --at to its profile")
      ->type_name("DIR")
      ->excludes(front)
      ->excludes(profile);
  CLI::Option* at = command.add_option("--at", fit.at, "Time of the profile, as in '2 s'; the end if absent");
  at->type_name("TIME")->excludes(front);
  command.add_option("--front-depth", fit.front_depth, "Depth of sand that is the front, as in '5 mm' (see below)")
      ->type_name("LENGTH")
      ->excludes(profile)
      ->excludes(at);
  command.add_option("--tolerance", fit.tolerance, "How well the data are known, as in '2 mm' (see below)")
      ->type_name("LENGTH");
}

void add_fit(CLI::App& app, Arguments& all) {
  FitArguments& fit = all.fit;
  CLI::App& command = *app.add_subcommand("fit", "Find values of a scene that give a measured front or profile");
  add_scene(command, fit.scene, fit.overrides);
  command.add_option("--vary", fit.vary, "What is looked for, between two bounds (see below); may be repeated")
      ->type_name("KEY=FROM:TO")
      ->allow_extra_args(false);
  add_fit_reference(command, fit);
  command.add_option("-o,--output", fit.output, "Output directory; results/NAME_fit if absent")->type_name("DIR");
  command.add_option("-j,--jobs", fit.parallel, "Runs at a time; one a processor if absent. The result is the same")
      ->type_name("N")
      ->check(CLI::Range(1, 4096));
  command
      .add_option("--evaluations", fit.evaluations,
                  "Runs that the search may take, 60 a parameter if absent; ranges and map come on top")
      ->type_name("N")
      ->check(CLI::Range(4, 100'000));
  command.add_option("--map", fit.map, "Points along each side of the map; 0: no map")
      ->type_name("N")
      ->check(CLI::Range(0, 0) | CLI::Range(2, 200))
      ->capture_default_str();
  command.add_option("--seed", fit.seed, "Of the points that the search starts from")
      ->type_name("S")
      ->capture_default_str();
  command.add_flag("--yes", fit.yes, "Run more than 1000 times, or longer than an hour");
  command.add_flag("--overwrite", fit.overwrite, "Remove the results of another fit from DIR");
  command.add_flag("-q,--quiet", fit.quiet, "No progress, warnings or summary; errors only");
  command.footer(help::fit);
  command.callback([&all] { all.command = [&all](Console& console) { return fit_command(all.fit, console); }; });
}

void add_check(CLI::App& app, Arguments& all) {
  CLI::App& command = *app.add_subcommand("check", "Validate a scene and say what running it would take");
  add_scene(command, all.check.scene, all.check.overrides);
  command.footer(help::check);
  command.callback([&all] { all.command = [&all](Console& console) { return check_command(all.check, console); }; });
}

void add_info(CLI::App& app, Arguments& all) {
  CLI::App& command = *app.add_subcommand("info", "What a result holds, and how its run went");
  command.add_option("RESULT", all.info.result, "Results directory or series file")->required();
  command.footer(help::info);
  command.callback([&all] { all.command = [&all](Console& console) { return info_command(all.info, console); }; });
}

void add_schema(CLI::App& app, Arguments& all) {
  CLI::App& command = *app.add_subcommand("schema", "Print the JSON Schema of the scene format");
  command.add_flag("--reference", all.schema.reference, "Print the format's reference page (Markdown) instead");
  command.footer(help::schema);
  command.callback([&all] { all.command = [&all](Console& console) { return schema_command(all.schema, console); }; });
}

void add_devices(CLI::App& app, Arguments& all) {
  CLI::App& command = *app.add_subcommand("devices", "List what sandsim can run on");
  command.footer(help::devices);
  command.callback([&all] { all.command = devices_command; });
}

void add_bench(CLI::App& app, Arguments& all) {
  BenchArguments& bench = all.bench;
  CLI::App& command = *app.add_subcommand("bench", "Measure the step against this machine's copy bandwidth");
  add_device(command, bench.device, "What is measured; cpu if absent", "cpu|cuda", {"cpu", "cuda"});
  command
      .add_option("--size", bench.size,
                  "Cells along each side; 2048 if absent, with --device cuda all of 64, 128, ..., 16384")
      ->type_name("N")
      ->check(CLI::Range(16, 32768));
  add_threads(command, bench.threads, "one a processor");
  command.add_option("--repeats", bench.repeats, "Measurements of each number")
      ->type_name("K")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  add_precision(command, bench.precision, "Only this precision; both if absent");
  command.add_flag("--quick", bench.quick, "Small grids and few repeats: seconds, but rough numbers");
  command.add_flag("--json", bench.json, "Print the numbers as JSON");
  command.footer(help::bench);
  command.callback([&all] { all.command = [&all](Console& console) { return bench_command(all.bench, console); }; });
}

void add_study(CLI::App& app, Arguments& all) {
  StudyArguments& study = all.study;
  CLI::App& command = *app.add_subcommand("study", "Measure error against run time, and what features cost");
  command.add_option("STUDY", study.study, "Study file, or a folder that holds a study.yaml")->required();
  command.add_option("-o,--output", study.output, "Output directory; results/study_NAME if absent")->type_name("DIR");
  command.add_option("--repeats", study.repeats, "Timed runs of each setting, instead of the study's")
      ->type_name("N")
      ->check(CLI::Range(1, 1000));
  command.add_option("--under", study.under, "Name the cheapest setting with at most this error; may be repeated")
      ->type_name("ERROR")
      ->allow_extra_args(false)
      ->check(CLI::Range(1e-300, 1e300));
  command.add_flag("--shortest", study.shortest, "The shortest repeat counts, not the median: for busy machines");
  command.add_flag("--quick", study.quick, "One repeat and the three coarsest spacings: shows that it works");
  command.add_flag("--list", study.list, "Print the settings that would be run, and run nothing");
  command.add_flag("--overwrite", study.overwrite, "Write into a DIR that is not empty");
  command.add_flag("-q,--quiet", study.quiet, "No progress and no tables; errors only");
  command.footer(help::study);
  command.callback([&all] { all.command = [&all](Console& console) { return study_command(all.study, console); }; });
}

void add_stress(CLI::App& app, Arguments& all) {
  StressArguments& stress = all.stress;
  CLI::App& command = *app.add_subcommand("stress", "Run stiff and extreme cases and judge them");
  command.add_option("SCENE", stress.scenes, "Scenes to judge instead of the built-in matrix");
  command.add_option("-o,--output", stress.output, "Output directory")->type_name("DIR")->capture_default_str();
  command.add_flag("--overwrite", stress.overwrite, "Replace the results in DIR");
  command.add_flag("--quick", stress.quick, "Every eighth case and the corners of the maps");
  command.add_option("--random", stress.randoms, "Scenes drawn at random; more of them leave the first as they are")
      ->type_name("N")
      ->check(CLI::Range(0, 100000))
      ->capture_default_str();
  command.add_option("--only", stress.only, "Only cases with TEXT in their names")->type_name("TEXT");
  add_device(command, stress.device, "What they run on; cpu if absent", "cpu|cuda", {"cpu", "cuda"});
  command.add_option("-j,--jobs", stress.jobs, "Runs side by side; all processors if absent, 1 with cuda")
      ->type_name("N")
      ->check(CLI::Range(1, 4096));
  add_wall_limit(command, stress.max_wall, "Give a run up after this much time; 30 s if absent, none for SCENE");
  command.footer(help::stress);
  command.callback([&all] { all.command = [&all](Console& console) { return stress_command(all.stress, console); }; });
}

void add_everything(CLI::App& app, Arguments& all) {
  app.set_version_flag("--version", source_line(), "Print the version and exit");
  app.require_subcommand(1);
  app.footer(help::program);
  app.get_formatter()->column_width(34);
  add_run(app, all);
  add_sweep(app, all);
  add_fit(app, all);
  add_check(app, all);
  add_info(app, all);
  add_export(app, all.exported);
  app.get_subcommand("export")->callback(
      [&all] { all.command = [&all](Console& console) { return export_command(all.exported, console); }; });
  add_schema(app, all);
  add_devices(app, all);
  add_bench(app, all);
  add_study(app, all);
  add_stress(app, all);
}

int usage_error(std::ostream& err, const CLI::App& app, const std::string& message) {
  const auto chosen = app.get_subcommands();
  const std::string command = chosen.empty() ? "" : " " + chosen.front()->get_name();
  print_error(err, message + "\n  'sandsim" + command + " --help' shows the usage");
  return static_cast<int>(ExitCode::usage);
}

/// CLI11 only says that an argument was not expected; a missing or misspelt command deserves the list.
std::optional<std::string> wrong_command(const CLI::App& app, std::span<const std::string> args) {
  if (!args.empty() && args[0].starts_with("-")) {
    return std::nullopt;
  }
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(command->get_name());
  }
  if (!args.empty() && std::find(names.begin(), names.end(), args[0]) != names.end()) {
    return std::nullopt;
  }
  const std::string problem = args.empty() ? "no command" : "unknown command '" + args[0] + "'";
  return problem + "; the commands are " + join(", ", names);
}

/// The arguments as a shell would take them again.
std::string command_line(std::span<const std::string> args) {
  std::string line = "sandsim";
  for (const std::string& arg : args) {
    line += ' ' + shell_word(arg);
  }
  return line;
}

int run_chosen(const Arguments& arguments, Console& console) {
  try {
    return static_cast<int>(arguments.command(console));
  } catch (...) {
    const Failure failure = current_failure();
    print_error(console.err, failure.message);
    return failure.exit_code;
  }
}

}  // namespace

int run_app(std::span<const std::string> args, std::ostream& out, std::ostream& err) {
  CLI::App app("Dry granular flow on a height field.", "sandsim");
  Arguments arguments;
  add_everything(app, arguments);
  if (const auto message = wrong_command(app, args)) {
    return usage_error(err, app, *message);
  }
  try {
    app.parse(std::vector<std::string>(args.rbegin(), args.rend()));  // CLI11 takes them from the back.
  } catch (const CLI::CallForVersion& version) {
    out << version.what() << '\n';
    return static_cast<int>(ExitCode::done);
  } catch (const CLI::CallForHelp&) {
    out << app.help();
    return static_cast<int>(ExitCode::done);
  } catch (const CLI::ParseError& error) {
    return usage_error(err, app, error.what());
  }
  arguments.run.command_line = command_line(args);
  arguments.sweep.command_line = arguments.run.command_line;
  arguments.fit.command_line = arguments.run.command_line;
  arguments.stress.command_line = arguments.run.command_line;
  Console console{out, err, &err == &std::cerr && isatty(STDERR_FILENO) == 1};
  const int code = run_chosen(arguments, console);
  out.flush();
  if (code == static_cast<int>(ExitCode::done) && !out) {
    print_error(err, "cannot write to standard output");
    return static_cast<int>(ExitCode::output);
  }
  return code;
}

}  // namespace sandsim::cli
