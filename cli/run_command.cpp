#include <fmt/format.h>

#include <fstream>
#include <optional>
#include <ostream>
#include <sstream>

#include "cli/commands.hpp"
#include "cli/failures.hpp"
#include "cli/input_files.hpp"
#include "cli/memory.hpp"
#include "cli/run_paths.hpp"
#include "cli/run_session.hpp"
#include "io/output/checkpoint.hpp"
#include "io/output/json.hpp"
#include "io/output/mesh_cache.hpp"
#include "io/output/series_writer.hpp"
#include "io/scene/resolved_scene.hpp"
#include "io/scene/scene_reader.hpp"
#include "solver/device.hpp"
#include "solver/errors.hpp"

namespace sandsim::cli {

namespace fs = std::filesystem;

namespace {

RunInput read_input(const RunArguments& arguments, Console& console) {
  const fs::path file = scene_file(arguments.scene);
  std::vector<std::string> overrides = arguments.overrides;
  if (arguments.precision) {
    overrides.push_back("numerics.precision=" + *arguments.precision);
  }
  RunInput input;
  input.scene = read_scene(file, overrides, &input.warnings);
  for (const std::string& warning : input.warnings) {
    if (!arguments.quiet) {
      console.err << "sandsim: warning: " << warning << '\n';
    }
  }
  input.device = choose_device(arguments.device, input.scene.grid);
  require_memory(input.scene, input.device.device);
  // The copy in the results has to find the scene's files from there; the hash must not depend on where they are.
  input.resolved = resolved_scene(input.scene, fs::absolute(file).parent_path());
  input.hash = hash_of(input.scene, file);
  input.directory = arguments.output.empty() ? default_output_directory(file) : fs::path(arguments.output);
  return input;
}

std::string read_text(const fs::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Only a run that came to its end has a series without ".partial".
bool is_finished(const OutputFiles& files) {
  return fs::exists(files.series) && !fs::exists(partial_series_path(files.series));
}

/// Nothing is left to do: says so. Throws InputError if the finished run was one of another scene.
void report_finished(const RunArguments& arguments, const RunInput& input, const OutputFiles& files, Console& console) {
  if (read_text(files.report).find(json_string(input.hash)) == std::string::npos) {
    throw InputError(
        fmt::format("{}: holds the finished run of another scene; nothing to resume\n"
                    "  choose another directory with -o, or --overwrite it",
                    files.directory.string()));
  }
  if (arguments.json) {
    console.out << read_text(files.report);
  } else if (!arguments.quiet) {
    console.out << files.directory.string() << ": the run is finished; nothing to resume\n";
  }
}

Checkpoint load_checkpoint(const RunInput& input, const OutputFiles& files) {
  if (!fs::exists(files.checkpoint)) {
    throw InputError(
        fmt::format("{}: no checkpoint to go on from\n"
                    "  a run leaves one when it is interrupted, and every output.checkpoint_interval; "
                    "start anew without --resume{}",
                    files.checkpoint.string(),
                    fs::exists(files.directory) ? ", with --overwrite if the directory holds results" : ""));
  }
  return read_checkpoint(files.checkpoint, input.hash);
}

/// Turns meshes into signed distances, or takes them from an earlier run: they are kept beside the results.
void bake_objects(RunInput& input, const RunArguments& arguments, Console& console) {
  const bool shows = console.terminal && !arguments.quiet;
  const auto progress = [&](const std::string& name, double done) {
    console.err << fmt::format("\rsandsim: mesh of '{}': {:3.0f} % baked{}", name, 100.0 * done, done < 1.0 ? "" : "\n")
                << std::flush;
  };
  bake_meshes(input.scene, fs::absolute(input.directory).parent_path(),
              shows ? progress : std::function<void(const std::string&, double)>{});
}

ExitCode run_scene(const RunArguments& arguments, Console& console, RunContext& context) {
  RunInput input = read_input(arguments, console);
  context.title = input.scene.title;
  context.scene_hash = input.hash;
  context.output = input.directory.string();
  const OutputFiles planned(input.directory);
  std::optional<Checkpoint> checkpoint;
  if (arguments.resume) {
    if (is_finished(planned)) {
      report_finished(arguments, input, planned, console);
      return ExitCode::done;
    }
    checkpoint = load_checkpoint(input, planned);
  }
  const OutputFiles files = prepare_output_directory(input.directory, arguments.overwrite, arguments.resume);
  bake_objects(input, arguments, console);
  RunSession session(arguments, input, files, context, console);
  return session.run(checkpoint ? &*checkpoint : nullptr);
}

}  // namespace

ExitCode run_command(const RunArguments& arguments, Console& console) {
  RunContext context;
  context.scene_file = arguments.scene;
  context.command_line = arguments.command_line;
  context.started = time_stamp();
  try {
    return run_scene(arguments, console, context);
  } catch (...) {
    // Whoever asked for a document gets one, whatever went wrong.
    if (arguments.json) {
      console.out << run_report_json(failed_report(current_failure()), context);
    }
    throw;
  }
}

}  // namespace sandsim::cli
