// What a result holds, in words: `sandsim info`.
#pragma once

#include <filesystem>
#include <string>

namespace sandsim {

/// Describes a series (dimensions, frames, range of time, variables with units and range) and the run it came from
/// (run.json beside it). `path` is an output directory or a .h5 or .partial file, also of a run that was killed.
/// Throws InputError if there is nothing, or nothing that can be read.
std::string describe_result(const std::filesystem::path& path);

}  // namespace sandsim
