#include "cli/operation_count.hpp"

#include <cmath>
#include <initializer_list>

namespace sandsim::cli {
namespace {

/// A number whose operations are counted. Operations between numbers that are the same for every cell are not: a
/// compiler moves them out of the loop.
struct Counted;
thread_local OperationCount tally;  // of the laws that run on this thread

struct CountedMask {
  bool set = false;
  friend CountedMask operator&(CountedMask a, CountedMask b) { return tally.simple += 1, CountedMask{a.set && b.set}; }
  friend CountedMask operator|(CountedMask a, CountedMask b) { return tally.simple += 1, CountedMask{a.set || b.set}; }
};

struct Counted {
  using value_type = double;
  double value = 0.0;
  bool fixed = false;  // the same for every cell

  Counted() = default;
  Counted(double v) : value(v), fixed(true) {}  // implicit: constants in formulas
  Counted(double v, bool is_fixed) : value(v), fixed(is_fixed) {}

  static Counted simple(double v, bool is_fixed) {
    tally.simple += is_fixed ? 0 : 1;
    return {v, is_fixed};
  }
  static Counted divided(double v, bool is_fixed) {
    tally.divided += is_fixed ? 0 : 1;
    return {v, is_fixed};
  }
  static CountedMask compared(bool v, bool is_fixed) {
    tally.simple += is_fixed ? 0 : 1;
    return {v};
  }
  friend Counted operator+(Counted a, Counted b) { return simple(a.value + b.value, a.fixed && b.fixed); }
  friend Counted operator-(Counted a, Counted b) { return simple(a.value - b.value, a.fixed && b.fixed); }
  friend Counted operator*(Counted a, Counted b) { return simple(a.value * b.value, a.fixed && b.fixed); }
  friend Counted operator/(Counted a, Counted b) { return divided(a.value / b.value, a.fixed && b.fixed); }
  friend Counted operator-(Counted a) { return simple(-a.value, a.fixed); }
  friend CountedMask operator<(Counted a, Counted b) { return compared(a.value < b.value, a.fixed && b.fixed); }
  friend CountedMask operator<=(Counted a, Counted b) { return compared(a.value <= b.value, a.fixed && b.fixed); }
  friend CountedMask operator>(Counted a, Counted b) { return compared(a.value > b.value, a.fixed && b.fixed); }
  friend CountedMask operator>=(Counted a, Counted b) { return compared(a.value >= b.value, a.fixed && b.fixed); }
  friend CountedMask operator==(Counted a, Counted b) { return compared(a.value == b.value, a.fixed && b.fixed); }
  friend CountedMask operator!=(Counted a, Counted b) { return compared(a.value != b.value, a.fixed && b.fixed); }
  friend Counted fabs(Counted a) { return simple(std::fabs(a.value), a.fixed); }
  friend Counted sqrt(Counted a) { return divided(std::sqrt(a.value), a.fixed); }
};

bool any_of(CountedMask mask) {
  return mask.set;
}
bool all_of(CountedMask mask) {
  return mask.set;
}

/// What `where(mask, target) = value` assigns to.
struct Chosen {
  CountedMask mask;
  Counted& target;
  void operator=(Counted yes) const {
    target = Counted::simple(mask.set ? yes.value : target.value, yes.fixed && target.fixed);
  }
};
Chosen where(CountedMask mask, Counted& target) {
  return {mask, target};
}

}  // namespace
}  // namespace sandsim::cli

#include "solver/physics/balanced_update.hpp"
#include "solver/physics/paper_scheme.hpp"
#include "solver/physics/velocity.hpp"
#include "solver/physics/wave_speed.hpp"

namespace sandsim::cli {
namespace {

using namespace physics;

Counted cell_value(double v) {
  return {v, false};
}

const Material<Counted> material{0.6, 1.0, 1e30};
const StepParameters<Counted> parameters = step_parameters<Counted>(0.01, 9.8, 0.002, 1e-10);

FaceSide<Counted> some_side() {
  FaceSide<Counted> side;
  for (Counted* value :
       {&side.h, &side.b, &side.normal, &side.transverse, &side.sh, &side.ss, &side.dh, &side.demand, &side.K}) {
    *value = cell_value(0.1);
  }
  side.material = material;
  return side;
}

FaceFlux<Counted> some_flux() {
  return {cell_value(0.1), cell_value(0.1), cell_value(0.1), cell_value(0.1), cell_value(0.1)};
}

template <int Order, bool Flat>
void run_balanced() {
  const Counted x = cell_value(0.2);
  const Profile3<Counted> profile{{x, x, x, x, x, x}, x, x, x, x};
  quotient_velocity(x, x, parameters.dry_depth);
  quotient_velocity(x, x, parameters.dry_depth);
  reconstruct<Order, Flat, false>(profile, profile, x, x, material, parameters);
  for (int axis = 0; axis < 2; ++axis) {
    if constexpr (Order == 2) {  // normal and transverse velocity of both sides, half a step on
      for (int value = 0; value < 4; ++value) {
        static_cast<void>(x + Counted(0.5) * x + x);
      }
    }
    balanced_flux<Flat>(some_side(), some_side(), parameters);
  }
  balanced_update<Order, false>(State<Counted>{x, x, x}, CellCore<Counted>{x, x, x, x, x, x}, some_flux(), some_flux(),
                                some_flux(), some_flux(), material, parameters);
  // The speed that bounds the next step.
  quotient_velocity(x, x, parameters.dry_depth);
  quotient_velocity(x, x, parameters.dry_depth);
  const Counted slope = length(compact_slope(differences<Flat>(profile.line), parameters.inverse_dx),
                               compact_slope(differences<Flat>(profile.line), parameters.inverse_dx));
  maximum(x, balanced_speed<false>(x, x, x, slope, material, parameters.g, parameters.dx, parameters.dry_depth));
}

template <bool Flat>
void run_paper() {
  const Counted x = cell_value(0.2);
  const PaperSwitches<Counted> switches{1.0, CountedMask{true}};
  const PaperSide<Counted> side{x, x, x};
  for (int value = 0; value < 4; ++value) {  // two for the step, two for the speed of the next
    desingularised_velocity(x, x, parameters.inverse_dx);
  }
  paper_flux(side, side, switches, parameters.g);
  paper_flux(side, side, switches, parameters.g);
  for (int axis = 0; axis < 2; ++axis) {
    static_cast<void>(x - x);
    if constexpr (!Flat) {
      static_cast<void>(x + (x - x));
    }
  }
  paper_update<false>(x, x, x, x, x, some_flux(), some_flux(), some_flux(), some_flux(), material, parameters);
  maximum(x, paper_speed<false>(x, x, x, parameters.g, Counted(0.25)));
}

}  // namespace

OperationCount count_operations(bool paper, int order, bool flat) {
  tally = {};
  if (paper) {
    flat ? run_paper<true>() : run_paper<false>();
  } else if (order == 2) {
    flat ? run_balanced<2, true>() : run_balanced<2, false>();
  } else {
    flat ? run_balanced<1, true>() : run_balanced<1, false>();
  }
  return tally;
}

}  // namespace sandsim::cli
