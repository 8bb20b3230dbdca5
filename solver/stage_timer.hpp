// Adds the time of a scope to a stage of the report.
#pragma once

#include <chrono>
#include <cstdint>

#include "solver/report.hpp"

namespace sandsim {

class StageTimer {
 public:
  /// `bytes` that the scope moves; `launches` 0 where a call of the stage is timed in two scopes.
  StageTimer(StageReport& stage, double bytes, std::int64_t launches = 1) : stage_(stage) {
    stage_.launches += launches;
    stage_.bytes += bytes;
  }
  ~StageTimer() { stage_.seconds += std::chrono::duration<double>(Clock::now() - start_).count(); }
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;

 private:
  using Clock = std::chrono::steady_clock;
  StageReport& stage_;
  Clock::time_point start_ = Clock::now();
};

}  // namespace sandsim
