#include "solver/backends/cpu/running_threads.hpp"

#include <fstream>

namespace sandsim::cpu {

int running_threads() {
  std::ifstream file("/proc/loadavg");
  double over_minutes[3] = {};
  int running = 0;
  file >> over_minutes[0] >> over_minutes[1] >> over_minutes[2] >> running;
  return file ? running : 0;
}

}  // namespace sandsim::cpu
