// Files that are either whole or not there.
#pragma once

#include <filesystem>
#include <string_view>

namespace sandsim {

/// Writes PATH.tmp, syncs it to the disk and renames it to PATH. Throws OutputError; an older PATH then stays as it
/// was.
void write_file_atomically(const std::filesystem::path& path, std::string_view text);

/// Syncs a file to the disk. Throws OutputError.
void sync_file(const std::filesystem::path& path);

/// Renames a synced file and syncs the directory, so that the new name survives a power cut. Throws OutputError.
void rename_durably(const std::filesystem::path& from, const std::filesystem::path& to);

/// Throws OutputError unless the file system of `path` has so many bytes free.
void require_free_space(const std::filesystem::path& path, double bytes);

}  // namespace sandsim
