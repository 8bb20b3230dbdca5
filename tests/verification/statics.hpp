// States at rest, built to stand just inside what friction can hold.
#pragma once

#include "tests/verification/cases.hpp"

namespace sandsim::test {

/// Steepness of a state relative to what friction holds: the largest of |ds|/(mu dx) over the faces that can carry
/// sand, and of the compact |grad s|/mu over wet cells, as numerics.md defines them. At most 1: at rest.
double steepness(const Case& test);

/// A pile with a wavy surface on random rough ground, partly dry, whose steepness is just below 0.999.
/// Seeds choose among the four hbar policies, and every other one has maps of friction, scale and cap.
Case rough_pile(std::uint64_t seed, Method method, Precision precision);

/// Sand without friction, level, with islands.
Case lake(std::uint64_t seed, Method method, Precision precision);

/// A cone of slope `part` times mu.
Case cone(double angle, double part, Method method, Precision precision);

}  // namespace sandsim::test
