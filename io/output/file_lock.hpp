// Locks between processes.
#pragma once

#include <filesystem>

namespace sandsim {

/// An advisory lock (flock) on a file or a directory. It belongs to whoever has its descriptor open, and so ends with
/// its last holder, however that ends. Where the file system knows no locks every one is granted: they guard against
/// doing work twice, not against corruption.
class FileLock {
 public:
  enum class Mode { wait, try_once };

  /// A file is created if it is not there. Throws OutputError if it cannot be opened.
  FileLock(const std::filesystem::path& path, Mode mode);
  ~FileLock();
  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&&) = delete;

  /// False if it was tried once and another process holds it.
  bool taken() const { return taken_; }
  /// Closed on exec, unless the child is meant to hold it.
  int descriptor() const { return descriptor_; }

 private:
  int descriptor_;
  bool taken_;
};

}  // namespace sandsim
