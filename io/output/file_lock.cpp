#include "io/output/file_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "solver/errors.hpp"

namespace sandsim {
namespace {

int open_for_lock(const std::filesystem::path& path) {
  std::error_code ignored;
  const bool directory = std::filesystem::is_directory(path, ignored);
  const int descriptor =
      ::open(path.c_str(), (directory ? O_RDONLY | O_DIRECTORY : O_RDWR | O_CREAT) | O_CLOEXEC, 0666);
  if (descriptor < 0) {
    throw OutputError(fmt::format("{}: could not be opened ({})", path.string(), std::strerror(errno)));
  }
  return descriptor;
}

}  // namespace

FileLock::FileLock(const std::filesystem::path& path, Mode mode) : descriptor_(open_for_lock(path)) {
  int result = 0;
  do {
    result = ::flock(descriptor_, LOCK_EX | (mode == Mode::try_once ? LOCK_NB : 0));
  } while (result != 0 && errno == EINTR);
  taken_ = result == 0 || errno != EWOULDBLOCK;
}

FileLock::FileLock(FileLock&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), taken_(std::exchange(other.taken_, false)) {}

FileLock::~FileLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace sandsim
