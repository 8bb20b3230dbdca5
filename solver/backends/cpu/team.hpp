// How many threads take a step.
#pragma once

#include <omp.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solver/backends/cpu/running_threads.hpp"

namespace sandsim::cpu {

/// Chooses between one thread and a team, by what steps have taken so far; or keeps to a number that was asked for. A
/// team waits for its slowest thread at every barrier: beside other busy processes, where that thread is off its
/// processor for milliseconds, a step of a small grid takes many times as long as with one thread. So a team has no
/// more threads than there are processors free for them, and is kept only if it is faster. Results do not depend on
/// the number, so that it may change from step to step.
class Team {
 public:
  /// `all` threads; with `adapts` at most so many, tried against one, now and then, for a small part of the time.
  /// `running` tells how many threads run on the processors or wait for one; 0: unknown.
  Team(int all, bool adapts, int processors = omp_get_num_procs(), int (*running)() = running_threads)
      : all_(all),
        processors_(processors),
        running_(running),
        adapts_(adapts),
        team_(!this->adapts()),
        preferred_(team_),
        together_(all),
        steps_(static_cast<std::size_t>(all) + 1, 0) {}

  bool adapts() const { return adapts_ && all_ > 1; }
  /// Threads that take the next step.
  int size() const { return team_ ? together_ : 1; }
  int most() const { return all_; }
  /// The number of threads that has taken most steps.
  int usual() const {
    const auto most = std::max_element(steps_.begin(), steps_.end());
    return *most > 0 ? static_cast<int>(most - steps_.begin()) : size();
  }
  /// Threads for other work than steps: those of `most` that have a processor each, beside what else runs now.
  int room_for(int most) const {
    const int running = adapts_ ? running_() : 0;
    return running == 0 ? most : std::clamp(processors_ - (running - size()), 1, most);
  }

  /// The step with size() threads took so long. Only if it adapts. [s]
  void took(double seconds) {
    steps_[static_cast<std::size_t>(size())] += 1;
    spent_ += seconds, count_ += 1, now_ += seconds;
    if (team_ != preferred_) {
      end_trial();
    } else if (spent_ >= window) {
      judge();
    }
  }

 private:
  static constexpr double window = 0.01;  // [s] steps are judged by their mean over this time: several time slices
  static constexpr int trial_steps = 6;   // of a trial, or fewer that fill the window
  static constexpr double lost = 3.0;     // a trial that is slower by this factor ends at once
  static constexpr double gain = 0.9;     // of the time, or the other choice does not pay
  static constexpr double shortest_pause = 0.1;     // [s] between trials
  static constexpr double longest_pause = 3.2;      // [s]
  static constexpr double steady = 0.5;             // [s] a team that was kept so long was good
  static constexpr double part_of_time = 1 / 40.0;  // that trials may take

  void start(bool team) {
    team_ = team;
    spent_ = 0.0, count_ = 0;
  }

  /// A window of the preferred choice is full.
  void judge() {
    mean_[team_] = spent_ / count_;
    const int free = room_for(all_);
    // A moment with less may be one of the system's own.
    together_ = team_ ? std::max(free, free_before_) : free;
    free_before_ = free;
    if (together_ == 1) {
      preferred_ = false;
      start(false);
      return;
    }
    const bool doubtful = team_ && mean_[true] > mean_[false];
    start(doubtful || now_ >= next_trial_ ? !preferred_ : preferred_);
  }

  void end_trial() {
    const double mean = spent_ / count_;
    const double other = mean_[preferred_];
    if (spent_ < window && count_ < trial_steps && mean < lost * other) {
      return;
    }
    mean_[team_] = mean;
    const bool is_better = mean < gain * other;
    if (is_better && team_) {
      since_ = now_;
    } else {
      // A team that was good for long is tried again soon; what loses again and again, more and more seldom.
      const bool was_good = is_better && now_ - since_ > steady;
      pause_ = was_good ? shortest_pause : std::min(2.0 * pause_, longest_pause);
    }
    next_trial_ = now_ + std::max(is_better && team_ ? shortest_pause : pause_, spent_ / part_of_time);
    preferred_ = is_better ? team_ : preferred_;
    start(preferred_);
  }

  int all_;
  int processors_;
  int (*running_)();
  bool adapts_;
  bool team_;                             // takes the next step; else one thread does
  bool preferred_;                        // which of the two is used but for trials
  int together_;                          // threads of the team
  int free_before_ = 1;                   // processors for it at the end of the window before
  std::array<double, 2> mean_{0.0, 0.0};  // [s] of a step, with one thread and with the team; 0: not known
  std::vector<std::int64_t> steps_;       // taken by each number of threads
  double spent_ = 0.0;                    // [s] in the window or trial that goes on
  int count_ = 0;                         // steps of it
  double now_ = 0.0;                      // [s] spent in steps
  double next_trial_ = 0.0;               // [s] on that clock
  double pause_ = shortest_pause;         // [s]
  double since_ = 0.0;                    // [s] on that clock: when the team was taken
};

}  // namespace sandsim::cpu
