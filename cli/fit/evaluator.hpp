// One evaluation of a fit: a run of the scene in memory, and how far it is from the reference.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "cli/fit/parameters.hpp"
#include "cli/fit/reference.hpp"

namespace sandsim::cli {

/// Which part of a fit asked for a run. Tasks of a stage go side by side; their order of numbers is always the same.
struct Origin {
  enum class Stage { start, search, range, map };

  Stage stage = Stage::start;
  std::size_t task = 0;
  std::size_t step = 0;  // counts the runs of the task
};

struct Evaluation {
  Origin origin;
  FitPoint point;
  double misfit = 0.0;   // [m] root mean square difference; NaN if the run failed
  std::string status;    // as in run.json
  std::string message;   // why there is no misfit
  double seconds = 0.0;  // [s] of wall clock
  bool failed() const;
};

/// A signal came: the fit ends.
struct FitInterrupted {};

/// Runs scenes. May be called from several threads at a time.
class Evaluator {
 public:
  using Observer = std::function<void(const Evaluation&)>;

  /// `base` has the scene, what is set, and the keys that vary. All arguments must live longer than this.
  Evaluator(const Sweep& base, const std::vector<FitParameter>& parameters, const FitReference& reference,
            std::filesystem::path mesh_folder, const std::atomic<bool>& interrupt);

  /// Told each evaluation, one at a time.
  void observe(Observer observer) { observer_ = std::move(observer); }

  /// Runs the scene at a point, on one thread. A run that fails or has no front gives an evaluation that says so.
  /// Throws FitInterrupted, DeviceError, InputError.
  Evaluation evaluate(const FitPoint& point, const Origin& origin);

  const std::vector<FitParameter>& parameters() const { return parameters_; }
  const FitReference& reference() const { return reference_; }
  /// All evaluations so far, in an order that does not depend on how many went side by side.
  std::vector<Evaluation> log() const;

 private:
  void run(Evaluation& evaluation) const;

  const Sweep& base_;
  const std::vector<FitParameter>& parameters_;
  const FitReference& reference_;
  std::filesystem::path mesh_folder_;
  const std::atomic<bool>& interrupt_;
  Observer observer_;
  mutable std::mutex mutex_;
  std::vector<Evaluation> log_;
};

/// Calls work(0) ... work(count - 1), `parallel` at a time, and throws the first of what they threw.
void for_each_task(std::size_t count, int parallel, const std::function<void(std::size_t)>& work);

}  // namespace sandsim::cli
