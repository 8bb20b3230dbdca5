#include "io/output/disk_space.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "io/output/atomic_file.hpp"
#include "solver/errors.hpp"

namespace sandsim {
namespace {

// Claims are rounded up to this, so that small frames do not cost a call each. [bytes]
constexpr std::int64_t claim_unit = 1 << 20;

void check_size_limit(std::int64_t size, const std::filesystem::path& path) {
  struct rlimit limit {};
  if (::getrlimit(RLIMIT_FSIZE, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return;
  if (static_cast<rlim_t>(size) > limit.rlim_cur) {
    throw OutputError(
        fmt::format("{}: no space left: the limit on the size of a file is {:.1f} MB (ulimit -f), "
                    "{:.1f} MB needed",
                    path.string(), static_cast<double>(limit.rlim_cur) / 1e6, static_cast<double>(size) / 1e6));
  }
}

/// False where the file system cannot claim space.
bool claim_blocks(int descriptor, std::int64_t from, std::int64_t bytes, const std::filesystem::path& path) {
  while (::fallocate(descriptor, FALLOC_FL_KEEP_SIZE, from, bytes) != 0) {
    if (errno == EINTR) continue;
    if (errno == EOPNOTSUPP || errno == ENOSYS || errno == EINVAL) return false;
    throw OutputError(fmt::format("{}: no space for the next frame: could not claim {:.1f} MB ({})", path.string(),
                                  static_cast<double>(bytes) / 1e6, std::strerror(errno)));
  }
  return true;
}

}  // namespace

DiskSpace::DiskSpace(int descriptor, std::filesystem::path path)
    : descriptor_(descriptor), path_(std::move(path)), last_check_(std::chrono::steady_clock::now()) {}

void DiskSpace::claim(std::int64_t bytes) {
  struct stat state {};
  if (::fstat(descriptor_, &state) != 0) {
    throw OutputError(fmt::format("{}: could not ask for its size ({})", path_.string(), std::strerror(errno)));
  }
  const std::int64_t size = state.st_size;
  if (size + bytes <= claimed_until_) return;
  check_size_limit(size + bytes, path_);
  const std::int64_t rounded = (bytes + claim_unit - 1) / claim_unit * claim_unit;
  if (!claim_blocks(descriptor_, size, rounded, path_)) require_free_space(path_, static_cast<double>(rounded));
  claimed_until_ = size + bytes;
}

void DiskSpace::check_written() {
  const auto now = std::chrono::steady_clock::now();
  if (now - last_check_ < std::chrono::seconds(2)) return;
  last_check_ = now;
  if (::fdatasync(descriptor_) != 0) {
    throw OutputError(fmt::format("{}: could not write to the disk ({})", path_.string(), std::strerror(errno)));
  }
}

void release_claimed_space(const std::filesystem::path& path) {
  std::error_code ignored;
  const auto size = std::filesystem::file_size(path, ignored);
  if (!ignored) std::filesystem::resize_file(path, size, ignored);
}

}  // namespace sandsim
