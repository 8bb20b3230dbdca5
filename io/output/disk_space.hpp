// Space for a file that grows, claimed before it is written to. Internal to io/output.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>

namespace sandsim {

/// HDF5 goes on without an error on a full disk, and what it leaves then may not open again. So every frame's space
/// is claimed first: with the file system where it can do that, otherwise by looking at what is free.
class DiskSpace {
 public:
  /// `descriptor` stays open and owned by the caller.
  DiskSpace(int descriptor, std::filesystem::path path);

  /// Claims `bytes` behind the end of the file. Throws OutputError if the disk, the quota or the limit on the size of
  /// a file does not allow them.
  void claim(std::int64_t bytes);

  /// Makes the system report errors of writing that it has kept for later; at most every two seconds, since it may
  /// take longer than a frame. Throws OutputError.
  void check_written();

 private:
  int descriptor_;
  std::filesystem::path path_;
  std::int64_t claimed_until_ = 0;  // [bytes] from the start of the file
  std::chrono::steady_clock::time_point last_check_;
};

/// Gives back what was claimed behind the end of a closed file.
void release_claimed_space(const std::filesystem::path& path);

}  // namespace sandsim
