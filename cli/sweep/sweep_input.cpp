#include "cli/sweep/sweep_input.hpp"

#include <fmt/format.h>

#include "cli/run_paths.hpp"
#include "cli/text.hpp"
#include "io/sweep/read_sweep.hpp"
#include "solver/errors.hpp"

namespace sandsim::cli {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void usage(const std::string& message) {
  throw Error(ExitCode::usage, message);
}

std::string message_of(const std::string& subject, const Complaint& complaint) {
  return subject + ": " + complaint.problem + (complaint.why.empty() ? "" : " (" + complaint.why + ")") + "." +
         (complaint.suggestion.empty() ? "" : " " + complaint.suggestion);
}

/// The scene or sweep file that the user means.
fs::path input_file(const std::string& given) {
  std::error_code ignored;
  const fs::path sweep_file = fs::path(given) / "sweep.yaml";
  return fs::is_regular_file(sweep_file, ignored) ? sweep_file : scene_file(given);
}

/// results/NAME_sweep, for sweep.yaml after its folder; a name that says so already is left alone.
fs::path default_directory(const fs::path& file) {
  const bool nameless = file.stem() == "sweep";
  const fs::path directory = default_output_directory(nameless ? file.parent_path() / "scene.yaml" : file);
  return directory.string().ends_with("sweep") ? directory : fs::path(directory.string() + "_sweep");
}

void read_options(SweepPlan& plan, const SweepArguments& arguments) {
  for (const std::string& text : arguments.vary) {
    if (const std::optional<Complaint> complaint = add_vary(plan, text)) {
      usage(message_of("--vary " + shown(text, 200), *complaint));
    }
  }
  plan.overrides.insert(plan.overrides.end(), arguments.overrides.begin(), arguments.overrides.end());
  if (arguments.precision) {
    plan.overrides.push_back("numerics.precision=" + *arguments.precision);
  }
  if (arguments.samples) {
    plan.samples.count = *arguments.samples;
  }
  if (arguments.seed) {
    plan.samples.seed = *arguments.seed;
  }
  if (arguments.sampling) {
    plan.samples.sampling = *arguments.sampling == "random" ? Sampling::random : Sampling::latin;
  }
  if (const std::optional<Complaint> complaint = check_plan(plan)) {
    usage(message_of("sweep", *complaint));
  }
}

void require_few(const SweepPlan& plan, bool yes) {
  const std::uint64_t count = plan.count();
  if (count > too_many_cases) {
    usage(fmt::format("sweep: more than {} cases.", format_count(static_cast<std::int64_t>(too_many_cases))));
  }
  if (count > many_cases && !yes) {
    usage(
        fmt::format("sweep: {} cases. Fewer values, or --samples of intervals, make it smaller; if all of them are "
                    "meant, say --yes.",
                    format_count(static_cast<std::int64_t>(count))));
  }
}

void require_valid(const Sweep& sweep, const SweepArguments& arguments) {
  const std::string problems = problems_of(sweep);
  if (problems.empty() || arguments.skip_invalid) {
    return;
  }
  throw SceneError(problems + "; nothing was run\n  --skip-invalid records them and runs the others");
}

OpenSweep open_existing(const SweepArguments& arguments) {
  const bool describes = !arguments.vary.empty() || !arguments.overrides.empty() || arguments.samples ||
                         arguments.sampling || arguments.seed || arguments.precision || !arguments.output.empty() ||
                         arguments.overwrite;
  if (describes) {
    usage(
        fmt::format("{}: is the output of a sweep, which says itself what varies.\n"
                    "  To change it name its scene: sandsim sweep SCENE --vary ... -o {}",
                    arguments.scene, arguments.scene));
  }
  const SweepFiles files{fs::path(arguments.scene)};
  return {read_manifest(files), files, true, std::nullopt};
}

/// Whether the action runs all cases, or writes the sweep anew.
bool needs_all(const SweepArguments& arguments) {
  return !arguments.one_case && !arguments.collect && !arguments.list;
}

OpenSweep open_new(const SweepArguments& arguments) {
  const fs::path file = input_file(arguments.scene);
  SweepPlan plan;
  if (is_sweep_file(file)) {
    plan = read_sweep(file);
  } else {
    plan.scene = file;
  }
  read_options(plan, arguments);
  require_few(plan, arguments.yes);
  OpenSweep open{resolve_sweep(plan),
                 SweepFiles(arguments.output.empty() ? default_directory(file) : fs::path(arguments.output)), false,
                 std::nullopt};
  require_valid(open.sweep, arguments);
  if (!arguments.list) {
    open.lock.emplace(prepare_sweep_directory(open.sweep, open.files, arguments.overwrite));
  }
  return open;
}

}  // namespace

OpenSweep open_sweep(const SweepArguments& arguments) {
  OpenSweep open = holds_sweep(arguments.scene) ? open_existing(arguments) : open_new(arguments);
  if (!needs_all(arguments)) {
    open.lock.reset();
  } else if (!open.lock) {
    open.lock.emplace(lock_sweep(open.files));
  }
  return open;
}

void require_unchanged(const Sweep& sweep, std::size_t index) {
  const SweepCase& before = sweep.cases[index];
  if (resolve_case(sweep, before.values).folder != before.folder) {
    throw InputError(
        fmt::format("{}: has changed since the sweep was made, or a file that it reads, or sandsim's "
                    "defaults\n  undo the change, or make a new sweep in another directory",
                    sweep.scene.string()));
  }
}

}  // namespace sandsim::cli
