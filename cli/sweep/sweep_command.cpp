#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "cli/commands.hpp"
#include "cli/machine.hpp"
#include "cli/sweep/case_state.hpp"
#include "cli/sweep/sweep_display.hpp"
#include "cli/sweep/sweep_input.hpp"
#include "cli/sweep/sweep_script.hpp"
#include "cli/sweep/sweep_table.hpp"
#include "cli/text.hpp"
#include "io/output/atomic_file.hpp"
#include "solver/errors.hpp"

namespace sandsim::cli {

namespace fs = std::filesystem;

namespace {

using Kind = CaseState::Kind;

std::vector<CaseState> read_states(const OpenSweep& open) {
  std::vector<CaseState> states;
  for (std::size_t k = 0; k < open.sweep.cases.size(); ++k) {
    states.push_back(read_case_state(open.sweep, k, open.files.directory));
  }
  return states;
}

SweepCounts count(const std::vector<CaseState>& states) {
  SweepCounts counts;
  counts.total = states.size();
  const auto number = [&](Kind kind) {
    return static_cast<std::size_t>(
        std::count_if(states.begin(), states.end(), [kind](const CaseState& state) { return state.kind == kind; }));
  };
  counts.done = number(Kind::done);
  counts.failed = number(Kind::failed);
  counts.interrupted = number(Kind::interrupted);
  return counts;
}

void print_failures(const OpenSweep& open, const std::vector<CaseState>& states, std::ostream& out) {
  constexpr int most = 10;
  int failures = 0;
  for (std::size_t k = 0; k < states.size(); ++k) {
    if (states[k].kind != Kind::failed || ++failures > most) {
      continue;
    }
    out << fmt::format("  case {}: {} (exit code {}): {}  ({})\n", k + 1, states[k].status, states[k].exit_code,
                       states[k].message, open.sweep.description_of(open.sweep.cases[k]));
  }
  if (failures > most) {
    out << fmt::format("  ... and {} more: see {}\n", failures - most, open.files.csv.string());
  }
}

/// Writes the summary, and says how the sweep stands.
void conclude(const SweepArguments& arguments, const OpenSweep& open, const std::vector<CaseState>& states,
              Console& console) {
  if (!arguments.quiet) {
    console.out << fmt::format("{}: {} ({})\n", open.sweep.scene.string(), counts_line(count(states), "not run"),
                               join(", ", open.sweep.keys));
    print_failures(open, states, console.out);
  }
  const Table table = sweep_table(open.sweep, states, arguments.command_line);
  write_file_atomically(open.files.csv, csv_text(table));
  write_table(open.files.series, table);
  if (!arguments.quiet) {
    console.out << fmt::format("  {}: summary.csv, summary.h5, cases\n", open.files.directory.string());
  }
}

/// How many cases run at a time, with how many threads each.
struct Shares {
  int parallel = 1;
  int threads = 1;
};

Shares shares_of(const SweepArguments& arguments, std::size_t cases) {
  const int processors = default_threads();
  Shares shares;
  shares.threads = std::max(arguments.threads, 1);
  const int places = std::max(1, processors / shares.threads);
  shares.parallel = arguments.parallel > 0 ? arguments.parallel : places;
  shares.parallel = std::clamp(static_cast<int>(cases), 1, shares.parallel);
  if (arguments.parallel == 0 && arguments.threads == 0) {
    shares.threads = processors / shares.parallel;
  }
  return shares;
}

std::vector<std::string> run_options(const SweepArguments& arguments, int threads) {
  std::vector<std::string> options{"--threads", std::to_string(threads)};
  if (arguments.device != Device::automatic) {
    options.insert(options.end(), {"--device", arguments.device == Device::cuda ? "cuda" : "cpu"});
  }
  return options;
}

class SweepRun {
 public:
  SweepRun(const SweepArguments& arguments, const OpenSweep& open, Console& console)
      : arguments_(arguments), open_(open), console_(console), states_(read_states(open)) {
    for (std::size_t k = 0; k < states_.size(); ++k) {
      if (is_to_be_run(states_[k], arguments.retry)) {
        chosen_.push_back(k);
      }
    }
  }

  ExitCode run() {
    const SweepCounts before = counts_before();
    if (before.done > 0 && !arguments_.quiet) {
      console_.err << fmt::format("sandsim: {} of {} cases are done already\n", before.done, before.total);
    }
    for (const std::size_t index : chosen_) {
      if (open_.is_read_back) {
        require_unchanged(open_.sweep, index);
      }
    }
    const PoolResult result = run_chosen(before);
    conclude(arguments_, open_, states_, console_);
    return exit_code(result);
  }

 private:
  /// Cases that are to be run count as waiting, whatever they were.
  SweepCounts counts_before() const {
    std::vector<CaseState> states = states_;
    for (const std::size_t index : chosen_) {
      states[index].kind = Kind::not_run;
    }
    return count(states);
  }

  std::vector<CaseJob> jobs(int threads) const {
    std::vector<CaseJob> jobs;
    for (const std::size_t index : chosen_) {
      const SweepCase& one = open_.sweep.cases[index];
      jobs.push_back({fmt::format("case {}", index + 1), open_.sweep.scene, open_.sweep.overrides_of(one),
                      open_.files.directory / one.folder, true, run_options(arguments_, threads)});
    }
    return jobs;
  }

  PoolResult run_chosen(const SweepCounts& before) {
    using Mode = SweepDisplay::Mode;
    const Shares shares = shares_of(arguments_, states_.size());
    const Mode mode = arguments_.quiet ? Mode::none : console_.terminal ? Mode::table : Mode::lines;
    SweepDisplay display(console_.err, mode, open_.sweep, before);
    PoolSettings settings;
    settings.parallel = shares.parallel;
    settings.max_wall = arguments_.max_wall;
    settings.is_finished_elsewhere = [this](std::size_t job) {
      return read_case_state(open_.sweep, chosen_[job], open_.files.directory).kind == Kind::done;
    };
    PoolObserver observer;
    observer.started = [&](std::size_t) { display.case_started(); };
    observer.ended = [&](std::size_t job, const CaseOutcome& outcome) {
      CaseState& state = states_[chosen_[job]];
      state = case_state(open_.sweep, chosen_[job], open_.files.directory, outcome);
      display.case_ended(chosen_[job], state, outcome.wall_seconds);
    };
    observer.tick = [&](std::span<const RunningCase> running) {
      std::vector<RunningCase> cases(running.begin(), running.end());
      for (RunningCase& one : cases) {
        one.index = chosen_[one.index];
      }
      display.update(cases);
    };
    return run_cases(jobs(shares.threads), settings, observer);
  }

  ExitCode exit_code(const PoolResult& result) {
    if (!result.interrupted) {
      return exit_code_of(states_);
    }
    const std::string why = result.interrupted_by_limit ? "--max-wall reached" : "interrupted by " + result.signal;
    console_.err << fmt::format("sandsim: {}; the same command, or sandsim sweep {}, goes on\n", why,
                                shell_word(open_.files.directory.string()));
    return result.interrupted_by_limit ? ExitCode::wall_clock_limit : ExitCode::interrupted;
  }

  const SweepArguments& arguments_;
  const OpenSweep& open_;
  Console& console_;
  std::vector<CaseState> states_;
  std::vector<std::size_t> chosen_;  // cases that are to be run
};

ExitCode list_cases(const OpenSweep& open, Console& console) {
  for (std::size_t k = 0; k < open.sweep.cases.size(); ++k) {
    const CaseState state = read_case_state(open.sweep, k, open.files.directory);
    console.out << fmt::format("{:>5}  {}  {}  {}\n", k + 1, open.sweep.cases[k].folder, state.status,
                               open.sweep.description_of(open.sweep.cases[k]));
  }
  return ExitCode::done;
}

ExitCode expand(const SweepArguments& arguments, const OpenSweep& open, Console& console) {
  std::error_code error;
  fs::create_directories(open.files.directory / "slurm", error);
  const fs::path executable = fs::read_symlink("/proc/self/exe", error);
  const std::size_t cases = open.sweep.cases.size();
  write_file_atomically(open.files.script, sweep_script(open.files, cases, error ? "sandsim" : executable));
  if (!arguments.quiet) {
    const std::string directory = shell_word(open.files.directory.string());
    console.out << fmt::format("{} cases in {}\n", cases, open.files.directory.string());
    console.out << fmt::format("  sbatch {}\n", shell_word(open.files.script.string()));
    console.out << fmt::format("  seq {} | parallel --joblog {}/joblog sandsim sweep {} --case {{}} -q\n", cases,
                               directory, directory);
    console.out << fmt::format("  sandsim sweep {} --collect\n", directory);
  }
  return ExitCode::done;
}

ExitCode collect(const SweepArguments& arguments, const OpenSweep& open, Console& console) {
  const std::vector<CaseState> states = read_states(open);
  conclude(arguments, open, states, console);
  return exit_code_of(states);
}

/// Runs it in this process: whoever calls this runs each case as a process already.
ExitCode run_one(const SweepArguments& arguments, const OpenSweep& open, Console& console) {
  const auto number = static_cast<std::size_t>(*arguments.one_case);
  if (number > open.sweep.cases.size()) {
    throw Error(ExitCode::usage, fmt::format("--case {}: the sweep has {} cases", number, open.sweep.cases.size()));
  }
  const SweepCase& one = open.sweep.cases[number - 1];
  if (!one.problem.empty()) {
    throw SceneError(one.problem);
  }
  const fs::path folder = open.files.directory / one.folder;
  const FileLock lock = lock_case(folder);
  if (!lock.taken()) {
    throw OutputError(fmt::format("case {}: another process is running it", number));
  }
  if (read_case_state(open.sweep, number - 1, open.files.directory).kind == Kind::done) {
    if (!arguments.quiet) {
      console.out << fmt::format("case {} is done already\n", number);
    }
    return ExitCode::done;
  }
  require_unchanged(open.sweep, number - 1);
  RunArguments run;
  run.scene = open.sweep.scene.string();
  run.output = folder.string();
  run.overrides = open.sweep.overrides_of(one);
  run.device = arguments.device;
  run.threads = std::max(arguments.threads, 1);
  run.resume = can_resume_case(folder);
  run.overwrite = !run.resume;
  run.max_wall = arguments.max_wall;
  run.quiet = arguments.quiet;
  run.command_line = arguments.command_line;
  return run_command(run, console);
}

}  // namespace

ExitCode sweep_command(const SweepArguments& arguments, Console& console) {
  const OpenSweep open = open_sweep(arguments);
  for (const std::string& warning : open.sweep.warnings) {
    if (!arguments.quiet) {
      console.err << "sandsim: warning: " << warning << '\n';
    }
  }
  if (arguments.list) {
    return list_cases(open, console);
  }
  if (arguments.expand) {
    return expand(arguments, open, console);
  }
  if (arguments.one_case) {
    return run_one(arguments, open, console);
  }
  if (arguments.collect) {
    return collect(arguments, open, console);
  }
  return SweepRun(arguments, open, console).run();
}

}  // namespace sandsim::cli
