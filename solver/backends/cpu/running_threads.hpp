// How busy the machine is at this moment.
#pragma once

namespace sandsim::cpu {

/// Threads of all processes that run or wait for a processor now, the caller's among them; 0 where the system does not
/// tell (it is the fourth number of Linux's /proc/loadavg).
int running_threads();

}  // namespace sandsim::cpu
