#include "solver/backends/cpu/running_threads.hpp"

#include <omp.h>
#include <unistd.h>

#include <fstream>

namespace sandsim::cpu {

int running_threads() {
  if (omp_get_num_procs() < sysconf(_SC_NPROCESSORS_ONLN)) {
    return 0;  // kept to some of the processors: the system counts what runs on all
  }
  std::ifstream file("/proc/loadavg");
  double over_minutes[3] = {};
  int running = 0;
  file >> over_minutes[0] >> over_minutes[1] >> over_minutes[2] >> running;
  return file ? running : 0;
}

}  // namespace sandsim::cpu
