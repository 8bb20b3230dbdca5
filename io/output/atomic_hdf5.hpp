// HDF5 files that are either whole or not there.
#pragma once

#include <filesystem>
#include <functional>

#include "io/hdf5/hdf5.hpp"

namespace sandsim {

/// Lets `fill` write into PATH.tmp, syncs it to the disk and renames it to PATH. Opens a Session. Throws OutputError;
/// an older PATH then stays as it was.
void write_hdf5_atomically(const std::filesystem::path& path, const std::function<void(hid_t file)>& fill);

}  // namespace sandsim
