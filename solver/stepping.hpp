// The choice of time steps on the way to a frame, as plain numbers: a loop on the host and one on a device run the same
// code and take the same steps.
#pragma once

#include <cmath>
#include <cstdint>

#include "solver/physics/math.hpp"

namespace sandsim {

/// Why a loop of steps ends.
enum class Halt : int {
  none,
  due,             // the frame's time is reached
  at_rest,         // the state cannot change any more
  step_too_long,   // the fixed step breaks the stability bound
  step_collapsed,  // the stable step is below the shortest allowed
  broken,          // a value is not finite, or a depth is negative
  smallest_step,   // a step smaller than any before is planned: who wants to know its cell can look now
};

/// What does not change on the way to a frame.
struct StepRules {
  double due = 0.0;           // [s] time of the frame
  double fixed_step = 0.0;    // [s] 0: adaptive steps
  bool subcycle = false;      // a fixed step may be divided
  double minimum_step = 0.0;  // [s] an adaptive step below it is a collapse
  double rain_step = 0.0;     // [s] bound as long as some source is or will be open
  double rain_end = 0.0;      // [s] no source is open from here on
  double objects_end = 0.0;   // [s] no object moves, comes or goes from here on

  SANDSIM_HD bool rains_from(double time) const { return time < rain_end; }
};

/// Lengths of the steps taken. A step that was cut to land on a frame counts over the run only as long as no step was
/// limited by stability.
struct StepExtremes {
  double min = 0.0, max = 0.0;              // [s] over the run
  double frame_min = 0.0, frame_max = 0.0;  // [s] since the last frame
  bool any_limited = false;
  double smallest_time = 0.0;  // [s] when the smallest step was taken, to within 5 % of its length
  double smallest_step = 0.0;  // [s]
  int smallest_i = -1, smallest_j = -1;

  /// Takes in a planned step. True if it is the smallest limited one by 5 %: its cell is not known yet.
  SANDSIM_HD bool note(double step, double time, bool limited) {
    frame_min = frame_min == 0.0 ? step : physics::minimum(frame_min, step);
    frame_max = physics::maximum(frame_max, step);
    if (!limited && any_limited) {
      return false;
    }
    const bool first = min == 0.0 || (limited && !any_limited);
    const bool smallest = first || step < 0.95 * smallest_step;
    any_limited = limited;
    if (smallest) {
      smallest_time = time, smallest_step = step;
      smallest_i = smallest_j = -1;
    }
    min = first ? step : physics::minimum(min, step);
    max = first ? step : physics::maximum(max, step);
    return smallest && limited;
  }
};

/// What a step did.
struct StepOutcome {
  bool moving = false;      // some cell has momentum
  bool changed = false;     // some depth or momentum differs from before the step
  bool broken = false;      // some value is not finite, or a depth is negative
  double volume_out = 0.0;  // [m^3] left through open sides
};

/// Where a loop stands. The next step is planned before it is taken.
struct StepLoop {
  double time = 0.0;     // [s]
  double target = 0.0;   // [s] where the steps have to land next
  double bound = 0.0;    // [s] on the planned step
  double step = 0.0;     // [s] the planned step
  bool limited = false;  // the planned step is cut by the bound
  bool at_rest = false;
  Halt halt = Halt::none;
  std::int64_t steps = 0;    // taken
  double last_motion = 0.0;  // [s]
  double volume_in = 0.0;    // [m^3] rained
  double volume_out = 0.0;   // [m^3] left through open sides
  StepExtremes extremes;

  SANDSIM_HD void plan(const StepRules& rules, double stable_step);
  SANDSIM_HD void finish(const StepRules& rules, const StepOutcome& did);

 private:
  SANDSIM_HD void choose(const StepRules& rules);
};

/// The planned step's length. It has to land on the frame, or at the end of the running fixed step.
SANDSIM_HD void StepLoop::choose(const StepRules& rules) {
  const double whole = rules.fixed_step;
  target = rules.due;
  if (whole > 0.0) {
    const double end = (floor(time / whole + 1e-6) + 1.0) * whole;
    target = end > rules.due - 1e-6 * whole ? rules.due : end;
  }
  const double remaining = target - time;
  const bool fits = whole > 0.0 && physics::absolute(remaining - whole) < 1e-6 * whole;
  step = fits ? whole : remaining;  // the same bits in every fixed step
  limited = bound * (1.0 + 1e-6) < step;
  if (limited) {
    // The last steps before the target are made even, so that none is tiny.
    step = 2.0 * bound > step ? 0.5 * step : bound;
  }
}

/// Plans the step after the present state, whose largest stable step is `stable_step`; or sets `halt`. After
/// Halt::smallest_step the plan stands. A fixed step must keep to the bound unless it may be divided; an adaptive one
/// must not collapse.
SANDSIM_HD void StepLoop::plan(const StepRules& rules, double stable_step) {
  bound = rules.rains_from(time) ? physics::minimum(stable_step, rules.rain_step) : stable_step;
  if (!(time < rules.due)) {
    halt = Halt::due;
  } else if (at_rest) {
    halt = Halt::at_rest;
  } else if (rules.fixed_step > 0.0 && !rules.subcycle && rules.fixed_step > bound * (1.0 + 1e-6)) {
    halt = Halt::step_too_long;
  } else if (bound < rules.minimum_step) {
    halt = Halt::step_collapsed;
  } else {
    choose(rules);
    halt = extremes.note(step, time, limited) ? Halt::smallest_step : Halt::none;
  }
}

/// After the planned step: the time goes on, and rest is noticed. The same step again would give the same state; a step
/// cut short could hide a change below rounding and does not count.
SANDSIM_HD void StepLoop::finish(const StepRules& rules, const StepOutcome& did) {
  time = limited ? time + step : target;
  steps += 1;
  volume_out += did.volume_out;
  if (did.broken) {
    halt = Halt::broken;
  } else if (did.moving || did.changed) {
    last_motion = time;
  } else if (!rules.rains_from(time) && time >= rules.objects_end &&
             (rules.fixed_step > 0.0 || step >= 0.49 * physics::minimum(bound, 1e30))) {
    at_rest = true;
  }
}

}  // namespace sandsim
