// series.xdmf and particles.xdmf: through which ParaView opens series.h5.
#pragma once

#include <filesystem>

namespace sandsim {

/// Describes the frames of `series_file` (a finished or a partial series) in `xdmf_file`, which refers to it by a
/// path relative to itself. Writes nothing and returns false if the series holds no fields or no frames.
/// Throws InputError if the series cannot be read, OutputError if the description cannot be written.
bool write_xdmf(const std::filesystem::path& series_file, const std::filesystem::path& xdmf_file);

/// The same of the particles, as a cloud of points.
bool write_particle_xdmf(const std::filesystem::path& series_file, const std::filesystem::path& xdmf_file);

}  // namespace sandsim
