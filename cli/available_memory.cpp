#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "cli/machine.hpp"

namespace sandsim::cli {

namespace {

namespace fs = std::filesystem;

constexpr double unlimited = 1e18;  // [B] what control groups without a limit have, or more

/// The number behind a word at the beginning of a line.
std::optional<double> find_number(const fs::path& file, const std::string& word) {
  std::ifstream lines(file);
  for (std::string key, rest; lines >> key; std::getline(lines, rest)) {
    double value = 0.0;
    if (key == word && lines >> value) {
      return value;
    }
  }
  return std::nullopt;
}

/// A file of one number; none where it says "max".
std::optional<double> read_number(const fs::path& file) {
  double value = 0.0;
  return std::ifstream(file) >> value ? std::optional(value) : std::nullopt;
}

/// What a control group has left: cached files give way.
double room_in(const fs::path& group, const char* limit, const char* usage, const char* cached) {
  const std::optional<double> most = read_number(group / limit);
  if (!most || *most >= unlimited) {
    return unlimited;
  }
  const double used = read_number(group / usage).value_or(0.0);
  return std::max(0.0, *most - used + find_number(group / "memory.stat", cached).value_or(0.0));
}

/// The least of what the control groups of this process have left, each within those around it.
double room_in_control_groups() {
  double room = unlimited;
  std::ifstream groups("/proc/self/cgroup");  // "0::/path", or "9:memory:/path" in the first version
  for (std::string line; std::getline(groups, line);) {
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (second == std::string::npos) {
      continue;
    }
    const std::string controllers = "," + line.substr(first + 1, second - first - 1) + ",";
    const bool is_second_version = controllers == ",,";
    if (!is_second_version && controllers.find(",memory,") == std::string::npos) {
      continue;
    }
    const fs::path root = is_second_version ? "/sys/fs/cgroup" : "/sys/fs/cgroup/memory";
    // Within a container the path may be that of the host; the root is then the container's own group.
    for (fs::path path = line.substr(second + 1);; path = path.parent_path()) {
      const fs::path group = root / path.relative_path();
      room = std::min(room, is_second_version ? room_in(group, "memory.max", "memory.current", "inactive_file")
                                              : room_in(group, "memory.limit_in_bytes", "memory.usage_in_bytes",
                                                        "total_inactive_file"));
      if (!path.has_relative_path()) {
        break;
      }
    }
  }
  return room;
}

/// What `ulimit -v` leaves.
double room_in_address_space() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) {
    return unlimited;
  }
  const double used = read_number("/proc/self/statm").value_or(0.0) * static_cast<double>(sysconf(_SC_PAGESIZE));
  return std::max(0.0, static_cast<double>(limit.rlim_cur) - used);
}

}  // namespace

double available_memory() {
  const double free = 1024.0 * find_number("/proc/meminfo", "MemAvailable:").value_or(0.0);
  const double room = std::min(room_in_control_groups(), room_in_address_space());
  return free > 0.0 ? std::min(free, room) : room < unlimited ? room : 0.0;
}

}  // namespace sandsim::cli
