#include "cli/run_session.hpp"

#include <fmt/format.h>

#include <ostream>
#include <system_error>

#include "cli/progress.hpp"
#include "cli/summary.hpp"
#include "cli/text.hpp"
#include "io/output/atomic_file.hpp"
#include "io/output/checkpoint.hpp"
#include "io/output/series_writer.hpp"
#include "io/output/version.hpp"
#include "io/output/xdmf.hpp"
#include "solver/errors.hpp"

namespace sandsim::cli {

namespace fs = std::filesystem;

namespace {

constexpr std::chrono::seconds log_interval{10};

bool is_complete(const RunReport& report) {
  return report.exit_code == ExitCode::done;
}

bool can_resume(const RunReport& report) {
  return report.exit_code == ExitCode::interrupted || report.exit_code == ExitCode::wall_clock_limit;
}

/// "results/flume: series.h5, run.json, ...": what is there now.
std::string files_there(const OutputFiles& files) {
  std::vector<std::string> names;
  for (const fs::path& file : {files.series, partial_series_path(files.series), files.xdmf, files.particles_xdmf,
                               files.report, files.scene, files.log, files.checkpoint}) {
    if (fs::exists(file)) {
      names.push_back(file.filename().string());
    }
  }
  return files.directory.string() + ": " + join(", ", names);
}

}  // namespace

RunReport failed_report(const Failure& failure) {
  RunReport report;
  report.status = "failed";
  report.exit_code = static_cast<ExitCode>(failure.exit_code);
  report.message = failure.message;
  return report;
}

RunSession::RunSession(const RunArguments& arguments, const RunInput& input, const OutputFiles& files,
                       const RunContext& context, Console& console)
    : arguments_(arguments),
      input_(input),
      files_(files),
      context_(context),
      console_(console),
      log_(files.log, arguments.resume),
      next_log_(std::chrono::steady_clock::now() + log_interval) {}

ExitCode RunSession::run(const Checkpoint* checkpoint) {
  try {
    write_file_atomically(files_.scene, input_.resolved);
    log_start(checkpoint);
    const RunReport report = execute(checkpoint);
    conclude(report);
    return report.exit_code;
  } catch (...) {
    const Failure failure = current_failure();
    log_.error(failure.message);
    try {
      write_file_atomically(files_.report, run_report_json(failed_report(failure), context_));
    } catch (const OutputError& error) {
      // The disk that stopped the run does not take the report either: the first error is the one to tell.
      log_.error(error.what());
    }
    throw;
  }
}

RunReport RunSession::execute(const Checkpoint* checkpoint) {
  SeriesSettings settings{files_.series, input_.resolved, input_.device.name, arguments_.command_line, {}};
  if (checkpoint != nullptr) {
    settings.resume_frames = checkpoint->frames;
  }
  SeriesWriter writer(settings);
  AsyncSink sink(writer, [this](const std::string& message) { log_.error(message); });
  ProgressBar bar(console_.err, console_.terminal && !arguments_.quiet);
  ProgressFeed feed(arguments_.progress_fd);
  RunOptions options;
  options.device = input_.device.device;
  options.threads = arguments_.threads;
  options.interrupt = &signals_.interrupted();
  options.max_wall = arguments_.max_wall;
  options.resume = checkpoint;
  options.progress = [&](const Progress& progress) {
    bar.update(progress);
    log_progress(progress);
    feed.update(progress);
  };
  options.warn = [&](const std::string& warning) {
    log_.warning(warning);
    if (!arguments_.quiet) {
      console_.err << "sandsim: warning: " << warning << '\n';
    }
  };
  options.checkpoint = [&](const Checkpoint& state) { save(state, sink); };
  RunReport report = sandsim::run(input_.scene, options, sink);
  sink.drain();
  return report;
}

void RunSession::save(const Checkpoint& checkpoint, AsyncSink& sink) {
  // A checkpoint counts frames: they have to be in the file before it is.
  sink.drain();
  write_checkpoint(files_.checkpoint, checkpoint, input_.hash);
  checkpoint_written_ = true;
  log_.info(
      fmt::format("checkpoint at {:.6g} s, step {}, {} frames", checkpoint.time, checkpoint.steps, checkpoint.frames));
}

void RunSession::log_progress(const Progress& progress) {
  const auto now = std::chrono::steady_clock::now();
  if (!stepped_) {
    stepped_ = true;
    say(fmt::format("first step done {} after the start",
                    format_duration(std::chrono::duration<double>(now - arguments_.begin).count())));
  }
  if (now >= next_log_) {
    next_log_ = now + log_interval;
    log_.info(fmt::format("{:.6g} s of {:.6g} s, step {} of {}, {}", progress.time, progress.end, progress.steps,
                          format_duration(progress.step), format_rate(progress.cell_steps_per_second)));
  }
}

void RunSession::log_start(const Checkpoint* checkpoint) {
  log_.info(source_line());
  log_.info(arguments_.command_line);
  for (const std::string& warning : input_.warnings) {
    log_.warning(warning);
  }
  const Grid& grid = input_.scene.grid;
  say(fmt::format("{}: {} x {} cells of {:.4g} m, {}", arguments_.scene, grid.cells[0], grid.cells[1], grid.spacing,
                  input_.hash));
  say(fmt::format("device {} ({})", input_.device.name, input_.device.reason));
  say("results in " + files_.directory.string());
  if (checkpoint != nullptr) {
    say(fmt::format("going on from {:.6g} s, step {}, {} frames", checkpoint->time, checkpoint->steps,
                    checkpoint->frames));
  }
}

void RunSession::conclude(const RunReport& report) {
  write_xdmf_beside(is_complete(report));
  const std::string json = run_report_json(report, context_);
  write_file_atomically(files_.report, json);
  if (is_complete(report)) {
    std::error_code ignored;  // A checkpoint that stays does no harm: --resume looks for the finished series first.
    fs::remove(files_.checkpoint, ignored);
  }
  log_.info(fmt::format("{} at {:.6g} s after {} steps and {}, volume error {:.2e}", report.status,
                        report.simulated_time, report.steps, format_duration(report.wall_time), report.ledger.error()));
  if (arguments_.json) {
    console_.out << json;
  } else if (!arguments_.quiet) {
    console_.out << run_summary(input_.scene, report, files_there(files_));
  }
  print_end(report);
}

void RunSession::write_xdmf_beside(bool finished) {
  try {
    const fs::path series = finished ? files_.series : partial_series_path(files_.series);
    write_xdmf(series, files_.xdmf);
    write_particle_xdmf(series, files_.particles_xdmf);
  } catch (const InputError& error) {
    // The series of a run that did not finish may hold nothing to describe; a finished one must be readable.
    if (finished) {
      throw OutputError(error.what());
    }
    log_.warning(error.what());
  }
}

void RunSession::print_end(const RunReport& report) {
  if (is_complete(report)) {
    return;
  }
  if (!can_resume(report)) {
    log_.error(report.message);
    print_error(console_.err, report.message);
    return;
  }
  const bool interrupted = report.exit_code == ExitCode::interrupted;
  const std::string why = interrupted ? fmt::format("interrupted by {}", signals_.name()) : "--max-wall reached";
  const std::string next = checkpoint_written_ ? "; checkpoint written: the same command with --resume goes on" : "";
  log_.warning(why + next);
  console_.err << fmt::format("sandsim: {} at {:.6g} s of {:.6g} s{}\n", why, report.simulated_time,
                              input_.scene.time.end, next);
}

void RunSession::say(const std::string& message) {
  log_.info(message);
  if (arguments_.verbose) {
    console_.err << "sandsim: " << message << '\n';
  }
}

}  // namespace sandsim::cli
