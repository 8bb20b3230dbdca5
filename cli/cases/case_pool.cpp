#include "cli/cases/case_pool.hpp"

#include <signal.h>

#include <chrono>
#include <list>
#include <memory>
#include <optional>
#include <thread>

#include "cli/failures.hpp"
#include "cli/signals.hpp"
#include "io/output/output_directory.hpp"
#include "solver/errors.hpp"

namespace sandsim::cli {

namespace fs = std::filesystem;

namespace {

using Clock = std::chrono::steady_clock;

// Short beside any case, long beside asking whether one has ended.
constexpr std::chrono::milliseconds poll_interval{2};
constexpr std::chrono::milliseconds tick_interval{100};

double seconds(Clock::duration duration) {
  return std::chrono::duration<double>(duration).count();
}

std::vector<std::string> run_arguments(const CaseJob& job) {
  std::vector<std::string> words{"run", job.scene.string()};
  for (const std::string& text : job.overrides) {
    words.insert(words.end(), {"--set", text});
  }
  const bool resumes = job.resume && can_resume_case(job.output);
  words.insert(words.end(), {"-o", job.output.string(), resumes ? "--resume" : "--overwrite", "-q"});
  words.insert(words.end(), job.options.begin(), job.options.end());
  return words;
}

class Pool {
 public:
  Pool(std::span<const CaseJob> jobs, const PoolSettings& settings, const PoolObserver& observer)
      : jobs_(jobs), settings_(settings), observer_(observer) {
    result_.outcomes.resize(jobs.size());
    for (std::size_t index = 0; index < jobs.size(); ++index) {
      waiting_.push_back(index);
    }
  }

  PoolResult run() {
    while (!running_.empty() || (!waiting_.empty() && !result_.interrupted)) {
      const std::vector<std::size_t> ended = collect();
      if (!result_.interrupted) {
        look_for_an_end();
      }
      if (!result_.interrupted) {
        start_some();
      }
      // The places are taken again before anyone looks into the results.
      for (const std::size_t index : ended) {
        end(index);
      }
      tick();
      std::this_thread::sleep_for(poll_interval);
    }
    result_.wall_seconds = seconds(Clock::now() - begin_);
    return std::move(result_);
  }

 private:
  struct Running {
    std::size_t index;
    Clock::time_point begin;
    std::unique_ptr<CaseProcess> process;
  };

  void look_for_an_end() {
    const bool at_limit = settings_.max_wall > 0.0 && seconds(Clock::now() - begin_) >= settings_.max_wall;
    if (!signals_.interrupted() && !at_limit) {
      return;
    }
    result_.interrupted = true;
    result_.interrupted_by_limit = !signals_.interrupted();
    result_.signal = signals_.name();
    for (const Running& running : running_) {
      running.process->send(SIGTERM);
    }
  }

  /// Starts the first of the waiting cases whose directories are free, until all places are taken. Locked ones are
  /// asked for now and then only: there may be many.
  void start_some() {
    if (Clock::now() < next_start_) {
      return;
    }
    for (auto next = waiting_.begin(); next != waiting_.end();) {
      if (static_cast<int>(running_.size()) >= settings_.parallel) {
        return;
      }
      if (try_start(*next)) {
        next = waiting_.erase(next);
      } else {
        ++next;
        next_start_ = Clock::now() + tick_interval;
      }
    }
  }

  /// False if another process holds the case's directory.
  bool try_start(std::size_t index) {
    const Clock::time_point now = Clock::now();
    CaseOutcome& outcome = result_.outcomes[index];
    try {
      const FileLock lock = lock_case(jobs_[index].output);
      if (!lock.taken()) {
        return false;
      }
      outcome.started = true;
      outcome.begin = seconds(now - begin_);
      if (settings_.is_finished_elsewhere && settings_.is_finished_elsewhere(index)) {
        end(index);
        return true;
      }
      running_.push_back(
          {index, now, std::make_unique<CaseProcess>(settings_.executable, run_arguments(jobs_[index]), lock)});
      if (observer_.started) {
        observer_.started(index);
      }
    } catch (const Error&) {
      const Failure failure = current_failure();
      outcome.started = true;
      outcome.exit_code = failure.exit_code;
      outcome.error_text = failure.message;
      end(index);
    }
    return true;
  }

  /// Takes the cases that have ended from the running ones; returns their indices.
  std::vector<std::size_t> collect() {
    std::vector<std::size_t> ended;
    for (auto running = running_.begin(); running != running_.end();) {
      const std::optional<int> code = running->process->poll();
      if (!code) {
        ++running;
        continue;
      }
      CaseOutcome& outcome = result_.outcomes[running->index];
      // One that was not yet ready for signals had nothing to keep.
      const bool too_early = result_.interrupted && *code == 128 + SIGTERM;
      outcome.exit_code = too_early ? static_cast<int>(ExitCode::interrupted) : *code;
      outcome.error_text = running->process->error_text();
      outcome.wall_seconds = seconds(Clock::now() - running->begin);
      ended.push_back(running->index);
      running = running_.erase(running);
    }
    return ended;
  }

  void end(std::size_t index) const {
    if (observer_.ended) {
      observer_.ended(index, result_.outcomes[index]);
    }
  }

  void tick() {
    const Clock::time_point now = Clock::now();
    if (!observer_.tick || now < next_tick_) {
      return;
    }
    next_tick_ = now + tick_interval;
    std::vector<RunningCase> cases;
    for (const Running& running : running_) {
      cases.push_back({running.index, seconds(now - running.begin), running.process->progress()});
    }
    observer_.tick(cases);
  }

  std::span<const CaseJob> jobs_;
  const PoolSettings& settings_;
  const PoolObserver& observer_;
  SignalGuard signals_;
  PoolResult result_;
  std::list<std::size_t> waiting_;
  std::list<Running> running_;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point next_tick_ = begin_;
  Clock::time_point next_start_ = begin_;
};

}  // namespace

bool can_resume_case(const fs::path& directory) {
  // A series that is whole without a report beside it was cut short by a kill in its last moment: done anew.
  std::error_code ignored;
  const OutputFiles files(directory);
  return fs::exists(files.checkpoint, ignored) && !fs::exists(files.series, ignored);
}

PoolResult run_cases(std::span<const CaseJob> jobs, const PoolSettings& settings, const PoolObserver& observer) {
  return Pool(jobs, settings, observer).run();
}

}  // namespace sandsim::cli
