// How many threads take a step.
#pragma once

#include <omp.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "solver/backends/cpu/running_threads.hpp"

namespace sandsim::cpu {

/// Chooses between one thread and a team of all, by what steps have taken so far; or keeps to a number that was asked
/// for. A team waits for its slowest thread at every barrier: beside other busy processes, where that thread is off its
/// processor for milliseconds, a step of a small grid takes many times as long as with one thread. So a team is tried
/// only while there is a processor for each of its threads, kept only while that is so, and only if it is faster.
/// Results do not depend on the number, so that it may change from step to step.
class Team {
 public:
  /// `all` threads; with `adapts` they are tried against one, now and then, for a small part of the time.
  /// `running` tells how many threads of the machine run or wait for a processor; 0: unknown.
  Team(int all, bool adapts, int processors = omp_get_num_procs(), int (*running)() = running_threads)
      : all_(all),
        processors_(processors),
        running_(running),
        adapts_(adapts && all > 1),
        team_(!adapts_),
        preferred_(team_) {}

  bool adapts() const { return adapts_; }
  /// Threads that take the next step.
  int size() const { return team_ ? all_ : 1; }
  int most() const { return all_; }
  /// Threads that have taken most steps.
  int usual() const { return !adapts_ || steps_[true] > steps_[false] ? all_ : 1; }

  /// The step with size() threads took so long. Only if it adapts. [s]
  void took(double seconds) {
    steps_[team_] += 1;
    spent_ += seconds, count_ += 1, now_ += seconds;
    if (team_ != preferred_) {
      end_trial();
    } else if (spent_ >= window || (mean_[!team_] == 0.0 && count_ >= trial_steps)) {
      judge();
    }
  }

 private:
  static constexpr double window = 0.01;  // [s] steps are judged by their mean over this time: several time slices
  static constexpr int trial_steps = 6;   // of a trial, or fewer that fill the window
  static constexpr double lost = 3.0;     // a trial that is slower by this factor ends at once
  static constexpr double gain = 0.9;     // of the time, or the other choice does not pay
  static constexpr double shortest_pause = 0.1;     // [s] between trials; doubled by every lost one
  static constexpr double longest_pause = 3.2;      // [s]
  static constexpr double part_of_time = 1 / 40.0;  // that trials may take

  void start(bool team) {
    team_ = team;
    spent_ = 0.0, count_ = 0;
  }

  /// Whether there is a processor for every thread of a team beside what else runs now.
  bool has_room() const {
    const int running = running_();
    return running == 0 || running - size() + all_ <= processors_;
  }

  /// A window of the preferred choice is full.
  void judge() {
    mean_[team_] = spent_ / count_;
    const bool room = has_room();
    // A moment without room may be one of the system's own.
    const bool suffers = team_ && ((!room && !had_room_) || mean_[true] > mean_[false]);
    had_room_ = room;
    if (suffers) {
      pause();
      preferred_ = false;
    }
    const bool tries = !suffers && now_ >= next_trial_ && (team_ || room);
    start(tries ? !preferred_ : preferred_);
  }

  void end_trial() {
    const double mean = spent_ / count_;
    const double other = mean_[preferred_];
    if (spent_ < window && count_ < trial_steps && mean < lost * other) {
      return;
    }
    mean_[team_] = mean;
    if (mean < gain * other) {
      preferred_ = team_;
    }
    pause();
    start(preferred_);
  }

  void pause() {
    next_trial_ = now_ + std::max(pause_, spent_ / part_of_time);
    pause_ = std::min(2.0 * pause_, longest_pause);
  }

  int all_;
  int processors_;
  int (*running_)();
  bool adapts_;
  bool team_;                             // takes the next step; else one thread does
  bool preferred_;                        // which of the two is used but for trials
  std::array<double, 2> mean_{0.0, 0.0};  // [s] of a step, with one thread and with all; 0: not known
  std::array<std::int64_t, 2> steps_{0, 0};
  double spent_ = 0.0;             // [s] in the window or trial that goes on
  int count_ = 0;                  // steps of it
  double now_ = 0.0;               // [s] spent in steps
  double next_trial_ = 0.0;        // [s] on that clock
  bool had_room_ = true;           // at the end of the last window
  double pause_ = shortest_pause;  // [s]
};

}  // namespace sandsim::cpu
