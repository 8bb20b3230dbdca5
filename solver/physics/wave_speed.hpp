// The speeds that bound the time step.
#pragma once

#include "solver/physics/hbar.hpp"
#include "solver/physics/surface.hpp"

namespace sandsim::physics {

/// Balanced scheme: sum over the axes of |u| + max(c*, |u|), c* = max(sqrt(g hbar), sqrt(g hbar/h |G| dx)) where the
/// cell moves or its slope exceeds mu: the second term is the speed gained by sliding over one cell. [m/s]
/// The stable step is courant dx over the largest of these.
template <bool OneD, class R>
SANDSIM_HD R balanced_speed(R h, R u, R v, R slope, const Material<R>& m, R g, R dx, R dry_depth) {
  const R thickness = hbar(h, m);
  const R wave = square_root(g * thickness);
  const auto slides = (h > dry_depth) & ((u != R(0)) | (v != R(0)) | (slope > m.mu));
  R c = wave;
  if (any(slides)) {
    const R slide = square_root(g * thickness / h * slope * dx);
    c = select(slides, maximum(wave, slide), wave);
  }
  const R a_x = absolute(u);
  const R along_x = a_x + maximum(c, a_x);
  if constexpr (OneD) {
    return along_x;
  } else {
    const R a_y = absolute(v);
    return along_x + (a_y + maximum(c, a_y));
  }
}

/// Paper's scheme: the larger of the bounds of eq. 14 (4 (|u| + sqrt(g h))) and eq. 34 (|u|/C), as one speed: the
/// stable step is dx over the largest of these. [m/s]
template <bool OneD, class R>
SANDSIM_HD R paper_speed(R h, R u, R v, R g, R courant) {
  const R c = square_root(g * h);
  const R fastest = OneD ? absolute(u) : maximum(absolute(u), absolute(v));
  return maximum(4 * (fastest + c), fastest / courant);
}

}  // namespace sandsim::physics
