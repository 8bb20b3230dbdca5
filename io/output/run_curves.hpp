// Fronts and profiles of a run that is kept in a file.
#pragma once

#include <filesystem>

#include "solver/scene.hpp"

namespace sandsim {

/// Where the front of a run's depth was at each of its frames that has one, see front(). `path` is a results folder, or
/// a series.h5 or series.h5.partial. `threshold` [m]. Throws InputError if it cannot be read or holds no depth.
FrontCurve read_run_front(const std::filesystem::path& path, double threshold);

/// The depth at the cell centres of a run of one row at `time` [s], linear between the frames about it and that of
/// the last frame after a run that came to rest. Throws InputError, also for a time that lies outside of the frames.
Profile read_run_profile(const std::filesystem::path& path, double time);

}  // namespace sandsim
