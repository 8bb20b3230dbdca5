#include "cli/machine.hpp"

#include <fmt/format.h>
#include <omp.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <string_view>

#include "cli/text.hpp"

namespace sandsim::cli {

namespace {

/// The text behind the colon of the first line that begins with `key`.
std::optional<std::string> find_entry(const char* file, std::string_view key) {
  std::ifstream lines(file);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t colon = line.find(':');
    if (line.starts_with(key) && colon != std::string::npos) {
      const std::size_t begin = line.find_first_not_of(" \t", colon + 1);
      return begin == std::string::npos ? "" : line.substr(begin);
    }
  }
  return std::nullopt;
}

std::string cuda_version(int number) {
  return fmt::format("{}.{}", number / 1000, number % 1000 / 10);
}

}  // namespace

std::string processor_name() {
  return find_entry("/proc/cpuinfo", "model name").value_or("unknown processor");
}

int default_threads() {
  return omp_get_max_threads();
}

int processor_count() {
  return static_cast<int>(std::max(1L, sysconf(_SC_NPROCESSORS_ONLN)));
}

double load_average() {
  double minute = 0.0;
  return getloadavg(&minute, 1) == 1 ? minute : 0.0;
}

std::string vector_instructions() {
#if defined(__AVX512F__)
  return "AVX-512 (512 bit)";
#elif defined(__AVX2__)
  return "AVX2 (256 bit)";
#elif defined(__AVX__)
  return "AVX (256 bit)";
#elif defined(__SSE2__)
  return "SSE2 (128 bit)";
#elif defined(__ARM_NEON)
  return "NEON (128 bit)";
#else
  return "no vector instructions";
#endif
}

std::size_t last_level_cache() {
  // The system's files first: on some virtual machines sysconf() sums up the caches of the whole host.
  for (const char* file :
       {"/sys/devices/system/cpu/cpu0/cache/index3/size", "/sys/devices/system/cpu/cpu0/cache/index2/size"}) {
    std::size_t kibibytes = 0;  // The file says "32768K".
    if (std::ifstream(file) >> kibibytes && kibibytes > 0) {
      return kibibytes << 10;
    }
  }
  const long largest = std::max(sysconf(_SC_LEVEL2_CACHE_SIZE), sysconf(_SC_LEVEL3_CACHE_SIZE));
  return largest > 0 ? static_cast<std::size_t>(largest) : std::size_t{32} << 20;
}

std::string cuda_line(const CudaSurvey& survey) {
  if (!survey.problem.empty()) {
    return survey.problem;
  }
  return fmt::format("{}, compute capability {}.{}, {} multiprocessors, {} of {} of memory free, driver {}, runtime {}",
                     survey.name, survey.capability / 10, survey.capability % 10, survey.processors,
                     format_bytes(static_cast<double>(survey.free)), format_bytes(static_cast<double>(survey.total)),
                     cuda_version(survey.driver), cuda_version(survey.runtime));
}

}  // namespace sandsim::cli
