// Many small jobs in child processes: a crash or a hang of one of them is its own result and takes nothing with it.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace sandsim::cli {

/// How a job ended.
struct JobEnd {
  std::string result;   // what the job returned
  std::string problem;  // else why there is no result: "killed by signal 11 (Segmentation fault)", "no answer in 60 s"
};

/// Calls job(k) for k < count in `workers` processes, forked from this one, each of which takes one job after the
/// other; one that dies or works longer than `limit` [s] on a job is replaced. `ended` is called here, in the order of
/// the ends. The process must have one thread when this is called. Throws std::system_error if it cannot fork.
void run_isolated(std::size_t count, int workers, double limit, const std::function<std::string(std::size_t)>& job,
                  const std::function<void(std::size_t, const JobEnd&)>& ended);

}  // namespace sandsim::cli
