// How busy the machine is at this moment.
#pragma once

namespace sandsim::cpu {

/// Threads of all processes that run or wait for a processor now, the caller's among them (the fourth number of Linux's
/// /proc/loadavg); 0 where the system does not tell, or this process may use a part of the processors only.
int running_threads();

}  // namespace sandsim::cpu
