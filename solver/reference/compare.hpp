// The error of a run against the references of its scene.
#pragma once

#include <span>
#include <vector>

#include "solver/initial_state.hpp"
#include "solver/report.hpp"
#include "solver/scene.hpp"

namespace sandsim {

/// [m] The front: the largest x at which the piecewise linear depth through the cell centres crosses `threshold`
/// downwards. Threshold 0 is the tip: the outer face of the last wet cell (deeper than 1e-8 spacings, which the
/// schemes call dry). The end of the grid if the last cell is deeper; NaN if no cell is. Over all rows in 2-D.
/// `depth` holds ny * nx values [m], x fastest.
double front(const Grid& grid, std::span<const double> depth, double threshold);

/// Errors of `depth` (ny * nx values [m]) at `time` [s] against each reference that the scene names, in the order
/// exact, profile, measured_profile, measured_front. References are compared as cell averages. A profile continues
/// with its end values outside its table. Norms of an exact solution are taken over the cells that no wall has
/// reached yet. A reference that does not apply (or whose file is missing) gives a report with a note and no norms.
/// Exact solutions take gravity, friction, hbar and slope from the scene and its initial state.
/// Without any of these but with front_depths, one report holds the computed fronts alone.
std::vector<ErrorReport> compare(const Scene& scene, const InitialState& initial, double time,
                                 std::span<const double> depth);

/// The error of `depth` (ny * nx values [m]) against a run on a finer grid of the same domain, `fine`, restricted to
/// the cells of `grid`, and the fronts of both at each depth [m] of `front_depths`.
ErrorReport compare_fine(const Grid& grid, std::span<const double> depth, const Grid& fine_grid,
                         std::span<const double> fine, double time, std::span<const double> front_depths);

/// The scene's exact solution at one moment, for the frames.
struct ReferenceFrame {
  std::vector<double> depth;  // [m] nx cell averages; empty if no profile is known now; NaN where a wall interferes
  double tip = 0.0;           // [m] position of the tip (Stoker: the shock); NaN if unknown
};
ReferenceFrame reference_at(const Scene& scene, const InitialState& initial, double time);

}  // namespace sandsim
