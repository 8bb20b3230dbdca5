#include "cli/study/timed_runs.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

#include "io/output/async_sink.hpp"
#include "io/output/series_writer.hpp"
#include "io/scene/resolved_scene.hpp"
#include "solver/simulation.hpp"
#include "solver/snapshot.hpp"

namespace sandsim::cli {

namespace fs = std::filesystem;

namespace {

/// Keeps the depth of the last frame and drops everything else.
class LastDepth : public Sink {
 public:
  void begin(const Scene&, const StaticFields&) override {}
  void frame(Frame frame) override {
    for (NamedField& field : frame.fields) {
      if (field.name == "depth") {
        depth_ = std::move(field.values);
      }
    }
  }
  void end(const FinalFields&) override {}
  std::vector<double> depth() const { return as_double(depth_); }

 private:
  FieldValues depth_;
};

double solving_seconds(const RunReport& report) {
  double seconds = 0.0;
  for (const StageReport& stage : report.stages) {
    seconds += stage.name == "frames" ? 0.0 : stage.seconds;
  }
  return seconds;
}

RunReport run_writing(const Scene& scene, const RunOptions& options, const fs::path& folder) {
  const fs::path series = folder / "scratch.h5";
  RunReport report;
  {
    SeriesWriter writer({series, resolved_scene(scene), "", "sandsim study", {}});
    AsyncSink sink(writer);
    report = run(scene, options, sink);
    sink.drain();
  }
  std::error_code ignored;  // what stays is overwritten by the next run
  fs::remove(series, ignored);
  fs::remove(partial_series_path(series), ignored);
  return report;
}

bool is_interrupted(const RoundOptions& options) {
  return options.interrupt != nullptr && options.interrupt->load(std::memory_order_relaxed);
}

void keep_times(TimedResult& result, const RunReport& report) {
  if (report.exit_code != ExitCode::done) {
    return;
  }
  result.solving.push_back(solving_seconds(report));
  result.wall.push_back(report.wall_time);
}

}  // namespace

TimedResult run_once(const TimedJob& job, const RoundOptions& options) {
  RunOptions how;
  how.device = job.device;
  how.threads = job.threads;
  how.interrupt = options.interrupt;
  TimedResult result;
  if (job.writes) {
    result.report = run_writing(*job.scene, how, options.scratch);
  } else {
    LastDepth sink;
    result.report = run(*job.scene, how, sink);
    result.depth = sink.depth();
  }
  return result;
}

std::vector<TimedResult> run_rounds(const std::vector<TimedJob>& jobs, const RoundOptions& options,
                                    const std::function<void(const std::vector<TimedResult>&)>& after_round) {
  std::vector<TimedResult> results(jobs.size());
  for (int round = 0; round <= options.repeats; ++round) {
    for (std::size_t place = 0; place < jobs.size() && !is_interrupted(options); ++place) {
      const std::size_t k = round % 2 == 0 ? place : jobs.size() - 1 - place;
      TimedResult& result = results[k];
      const bool is_known = round > 0 && static_cast<int>(result.wall.size()) >= round;  // by a long warm-up
      if (result.failed() || is_known) {
        continue;
      }
      if (options.progress) {
        options.progress(round, k);
      }
      TimedResult now = run_once(jobs[k], options);
      if (round > 0) {
        keep_times(result, now.report);
        continue;
      }
      result = std::move(now);
      if (result.report.wall_time >= long_run) {
        keep_times(result, result.report);
      }
    }
    if (after_round) {
      after_round(results);
    }
  }
  return results;
}

}  // namespace sandsim::cli
