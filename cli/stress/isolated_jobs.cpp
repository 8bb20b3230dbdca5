#include "cli/stress/isolated_jobs.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <system_error>
#include <utility>
#include <vector>

namespace sandsim::cli {

namespace {

using Clock = std::chrono::steady_clock;
using Job = std::function<std::string(std::size_t)>;

/// Sends all of it; false if the other side is gone.
bool send_all(int socket, const void* data, std::size_t size) {
  const char* at = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t sent = send(socket, at, size, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) {
      continue;
    }
    if (sent <= 0) {
      return false;
    }
    at += sent, size -= static_cast<std::size_t>(sent);
  }
  return true;
}

/// Receives exactly so much; false if the other side is gone before.
bool receive_all(int socket, void* data, std::size_t size) {
  char* at = static_cast<char*>(data);
  while (size > 0) {
    const ssize_t got = recv(socket, at, size, 0);
    if (got < 0 && errno == EINTR) {
      continue;
    }
    if (got <= 0) {
      return false;
    }
    at += got, size -= static_cast<std::size_t>(got);
  }
  return true;
}

/// The child's life: a job's number comes in, the length of its result and the result go out.
[[noreturn]] void serve(int socket, const Job& job) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // without its parent no one would read the results
  std::size_t index = 0;
  while (receive_all(socket, &index, sizeof index)) {
    const std::string result = job(index);
    const std::size_t size = result.size();
    if (!send_all(socket, &size, sizeof size) || !send_all(socket, result.data(), size)) {
      break;
    }
  }
  _exit(0);  // the parent's buffers are not ours to write
}

/// Why a worker is gone, from its wait status.
std::string death(int status) {
  return WIFSIGNALED(status) ? fmt::format("killed by signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status)))
                             : fmt::format("ended with exit code {}", WEXITSTATUS(status));
}

struct Worker {
  pid_t pid = -1;
  int socket = -1;
  std::size_t job = 0;
  Clock::time_point deadline{};
};

class Pool {
 public:
  Pool(const Job& job, double limit) : job_(job), limit_(limit) {}
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;
  ~Pool() {
    while (!workers_.empty()) {
      end(workers_.begin());
    }
  }

  std::size_t size() const { return workers_.size(); }
  void start(std::size_t job) {
    workers_.push_back(hire());
    give(workers_.back(), job);
  }
  /// Waits until some job ends. Its worker takes the next one, or is sent home.
  template <class Next, class Ended>
  void wait(const Next& next, const Ended& ended);

 private:
  using Place = std::vector<Worker>::iterator;

  Worker hire() const;
  void give(Worker& worker, std::size_t job) const {
    worker.job = job;
    worker.deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(limit_));
    send_all(worker.socket, &job, sizeof job);  // if the worker is gone, its silence will tell
  }
  /// Ends the worker, wherever it is; its wait status.
  int end(Place place);
  JobEnd collect(Place place, bool is_late);

  const Job& job_;
  double limit_;
  std::vector<Worker> workers_;
};

Worker Pool::hire() const {
  int sockets[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets) != 0) {
    throw std::system_error(errno, std::generic_category(), "cannot make a socket pair");
  }
  const pid_t pid = fork();
  if (pid < 0) {
    throw std::system_error(errno, std::generic_category(), "cannot fork");
  }
  if (pid == 0) {
    close(sockets[0]);
    for (const Worker& other : workers_) {
      close(other.socket);  // or the others would not notice the parent's end
    }
    serve(sockets[1], job_);
  }
  close(sockets[1]);
  Worker worker;
  worker.pid = pid, worker.socket = sockets[0];
  return worker;
}

int Pool::end(Place place) {
  int status = 0;
  kill(place->pid, SIGKILL);
  while (waitpid(place->pid, &status, 0) < 0 && errno == EINTR) {
  }
  close(place->socket);
  workers_.erase(place);
  return status;
}

/// The result of a worker that has something to say, has died, or is late; the last two are replaced.
JobEnd Pool::collect(Place place, bool is_late) {
  JobEnd done;
  std::size_t size = 0;
  if (!is_late && receive_all(place->socket, &size, sizeof size)) {
    done.result.resize(size);
    if (receive_all(place->socket, done.result.data(), size)) {
      return done;
    }
  }
  const int status = end(place);
  done.result.clear();
  done.problem = is_late ? fmt::format("no answer in {:g} s", limit_) : death(status);
  workers_.push_back(hire());
  return done;
}

template <class Next, class Ended>
void Pool::wait(const Next& next, const Ended& ended) {
  std::vector<pollfd> waiting;
  Clock::time_point first = Clock::time_point::max();
  for (const Worker& worker : workers_) {
    waiting.push_back({worker.socket, POLLIN, 0});
    first = std::min(first, worker.deadline);
  }
  const auto rest = std::chrono::duration_cast<std::chrono::milliseconds>(first - Clock::now()).count();
  poll(waiting.data(), waiting.size(), static_cast<int>(std::clamp<decltype(rest)>(rest + 1, 0, 1000)));
  for (std::size_t k = 0; k < waiting.size(); ++k) {
    const bool speaks = waiting[k].revents != 0, is_late = !speaks && Clock::now() >= workers_[k].deadline;
    if (!speaks && !is_late) {
      continue;
    }
    const Place place = workers_.begin() + static_cast<std::ptrdiff_t>(k);
    const std::size_t job = place->job;
    const JobEnd done = collect(place, is_late);
    Worker& free = done.problem.empty() ? workers_[k] : workers_.back();
    if (std::size_t another = 0; next(another)) {
      give(free, another);
    } else {
      end(workers_.begin() + (&free - workers_.data()));
    }
    ended(job, done);
    return;  // the places of the workers may have changed
  }
}

}  // namespace

void run_isolated(std::size_t count, int workers, double limit, const Job& job,
                  const std::function<void(std::size_t, const JobEnd&)>& ended) {
  Pool pool(job, limit);
  std::size_t given = 0;
  while (given < count && pool.size() < static_cast<std::size_t>(workers)) {
    pool.start(given++);
  }
  const auto next = [&](std::size_t& index) {
    index = given;
    return given < count && ++given > 0;
  };
  while (pool.size() > 0) {
    pool.wait(next, ended);
  }
}

}  // namespace sandsim::cli
