#include "io/output/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "solver/errors.hpp"

namespace sandsim {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, std::string_view tried) {
  throw OutputError(fmt::format("{}: could not {} ({})", path.string(), tried, std::strerror(errno)));
}

class Descriptor {
 public:
  Descriptor(const fs::path& path, int flags) : descriptor_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {}
  ~Descriptor() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int get() const { return descriptor_; }
  /// close() is the last to report an error of writing on some network file systems.
  bool close() { return ::close(std::exchange(descriptor_, -1)) == 0; }

 private:
  int descriptor_;
};

void write_all(int descriptor, std::string_view text, const fs::path& path) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) fail(path, "write");
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

void write_temporary(const fs::path& path, std::string_view text) {
  Descriptor file(path, O_WRONLY | O_CREAT | O_TRUNC);
  if (file.get() < 0) fail(path, "create the file");
  write_all(file.get(), text, path);
  if (::fsync(file.get()) != 0) fail(path, "sync to the disk");
  if (!file.close()) fail(path, "close");
}

}  // namespace

void write_file_atomically(const fs::path& path, std::string_view text) {
  fs::path temporary = path;
  temporary += ".tmp";
  try {
    write_temporary(temporary, text);
    rename_durably(temporary, path);
  } catch (...) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    throw;
  }
}

void sync_file(const fs::path& path) {
  const Descriptor file(path, O_RDONLY);
  if (file.get() < 0) fail(path, "open");
  if (::fsync(file.get()) != 0) fail(path, "sync to the disk");
}

void rename_durably(const fs::path& from, const fs::path& to) {
  if (std::rename(from.c_str(), to.c_str()) != 0) fail(from, "rename to " + to.filename().string());
  const fs::path directory = to.has_parent_path() ? to.parent_path() : fs::path(".");
  const Descriptor opened(directory, O_RDONLY | O_DIRECTORY);
  // Some file systems cannot sync a directory (EINVAL); the rename itself has succeeded by now.
  if (opened.get() >= 0 && ::fsync(opened.get()) != 0 && errno != EINVAL) fail(directory, "sync to the disk");
}

void require_free_space(const fs::path& path, double bytes) {
  struct statvfs disk {};
  if (::statvfs(path.c_str(), &disk) != 0) fail(path, "ask for the free space");
  const double free = static_cast<double>(disk.f_bavail) * static_cast<double>(disk.f_frsize);
  if (free < bytes) {
    throw OutputError(fmt::format("{}: no space left on the device: {:.1f} MB needed, {:.1f} MB free", path.string(),
                                  bytes / 1e6, free / 1e6));
  }
}

}  // namespace sandsim
