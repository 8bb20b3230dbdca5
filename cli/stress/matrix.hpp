// The built-in matrix of stiff and extreme cases, theme by theme.
#pragma once

#include <vector>

#include "cli/stress/stress_case.hpp"

namespace sandsim::cli {

/// Why the paper's scheme does not keep level sand at rest among steps of the bed.
inline constexpr const char* central_difference =
    "eq. 17 takes the central difference of s across islands and cliffs, which pushes level sand";
/// Why the paper's scheme stops with faces that are too steep.
inline constexpr const char* mean_of_faces =
    "eq. 17 sees the mean of two faces, so that single faces stay steeper than friction holds";

/// Friction from none to almost a wall, and jumps of it between neighbours.
std::vector<StressCase> friction_cases();
/// hbar from 1e-12 m to all of 100 m of sand, and jumps of it between neighbours.
std::vector<StressCase> hbar_cases();
/// Depths from 1e-8 to 1e5 m; the dam on a layer of eq. 35.
std::vector<StressCase> depth_cases();
/// Spacings, gravities, places and heights over many orders of magnitude.
std::vector<StressCase> scale_cases();
/// Slopes, cliffs, spikes, pits, random ground.
std::vector<StressCase> terrain_cases();
/// Fast sand: streams that collide, part, shear and hit.
std::vector<StressCase> velocity_cases();
/// Fixed steps from 0.1 to 10 stability bounds, Courant numbers, step limits.
std::vector<StressCase> step_cases();
/// Grids of odd shapes under each kind of boundary.
std::vector<StressCase> grid_cases();
/// Sources: in corners, violent, minute.
std::vector<StressCase> source_cases();
/// Objects that are fast, tiny, huge, spinning, jumping.
std::vector<StressCase> object_cases();

/// So many scenes drawn at random from all of the above but sources and objects; more of them leave the first as they
/// are.
std::vector<StressCase> random_cases(int count);
/// Heaps that have to come to rest, none of their faces steeper than friction holds.
std::vector<StressCase> stopping_cases();

inline constexpr int random_count = 200;

/// All of them with their themes, and so many random ones. Names are unique.
std::vector<StressCase> stress_matrix(int randoms = random_count);

/// The cells of the stability maps: Courant number x friction angle, and hbar/h x slope.
std::vector<StressCase> stability_maps();

/// Some of every theme, and the corners and the middle of every map: for tests.
std::vector<StressCase> quick_part(std::vector<StressCase> cases);

}  // namespace sandsim::cli
