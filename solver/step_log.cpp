#include "solver/step_log.hpp"

#include <algorithm>

namespace sandsim {

StepLog::StepLog(const Checkpoint& from)
    : min_(from.dt_min),
      max_(from.dt_max),
      frame_min_(from.frame_step_min),
      frame_max_(from.frame_step_max),
      any_limited_(from.smallest_step.i >= 0) {
  if (from.smallest_step.step > 0.0) {
    smallest_ = from.smallest_step;
  }
}

void StepLog::save(Checkpoint& to) const {
  to.dt_min = min_, to.dt_max = max_;
  to.frame_step_min = frame_min_, to.frame_step_max = frame_max_;
  to.smallest_step = smallest_.value_or(Incident{});
}

void StepLog::report(RunReport& to) const {
  to.dt_min = min_, to.dt_max = max_;
  to.smallest_step = smallest_;
}

void StepLog::note(double dt, double time, bool limited, const Backend& backend) {
  frame_min_ = frame_min_ == 0.0 ? dt : std::min(frame_min_, dt);
  frame_max_ = std::max(frame_max_, dt);
  if (!limited && any_limited_) {
    return;
  }
  const bool first = min_ == 0.0 || (limited && !any_limited_);
  any_limited_ = limited;
  // The cell is looked for when the step has shrunk by 5 %: the search costs a pass over the grid.
  if (first || dt < 0.95 * smallest_->step) {
    Incident incident;
    incident.time = time, incident.step = dt, incident.cause = "cut to land on a frame";
    if (limited) {
      const SpeedLimit limit = backend.speed_limit();
      incident.i = limit.i, incident.j = limit.j, incident.cause = "stability bound";
    }
    smallest_ = incident;
  }
  min_ = first ? dt : std::min(min_, dt);
  max_ = first ? dt : std::max(max_, dt);
}

}  // namespace sandsim
