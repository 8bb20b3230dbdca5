#include "cli/cases/case_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <sstream>
#include <string_view>

#include "solver/errors.hpp"

namespace sandsim::cli {

namespace fs = std::filesystem;

namespace {

constexpr int progress_descriptor = 3;  // in the child

[[noreturn]] void fail_to_start() {
  throw DeviceError(fmt::format("cannot start a process for a case ({})", std::strerror(errno)));
}

/// In the child, between fork and exec: only calls that are safe there. Returns if the program cannot be started.
void become_case(const char* executable, char* const* arguments, pid_t parent, int errors, int progress, int lock) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) {
    return;  // It died before the line above.
  }
  const int nothing = open("/dev/null", O_RDWR);
  dup2(nothing, STDIN_FILENO);
  dup2(nothing, STDOUT_FILENO);
  dup2(errors, STDERR_FILENO);
  // Descriptors that are in the way of number 3 are moved; a copy does not have O_CLOEXEC.
  const int kept_lock = lock == progress_descriptor ? dup(lock) : lock;
  fcntl(kept_lock, F_SETFD, 0);
  if (progress == progress_descriptor) {
    fcntl(progress, F_SETFD, 0);
  } else {
    dup2(progress, progress_descriptor);
  }
  execv(executable, arguments);
  constexpr std::string_view problem = "sandsim: error: the program cannot be started as a process for a case\n";
  if (write(STDERR_FILENO, problem.data(), problem.size()) < 0) {
    return;
  }
}

}  // namespace

AnonymousFile::AnonymousFile(const char* name) : descriptor_(memfd_create(name, MFD_CLOEXEC)) {
  if (descriptor_ < 0) {
    fail_to_start();
  }
}

AnonymousFile::~AnonymousFile() {
  close(descriptor_);
}

std::string AnonymousFile::text() const {
  std::string text(1 << 16, '\0');
  const ssize_t size = pread(descriptor_, text.data(), text.size(), 0);
  text.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
  return text;
}

FileLock lock_case(const fs::path& directory) {
  std::error_code error;
  fs::create_directories(directory, error);
  if (error) {
    throw OutputError(fmt::format("{}: could not be created ({})", directory.string(), error.message()));
  }
  return FileLock(directory / "case.lock", FileLock::Mode::try_once);
}

CaseProcess::CaseProcess(const fs::path& executable, const std::vector<std::string>& arguments, const FileLock& lock)
    : errors_("sandsim case errors"), progress_("sandsim case progress") {
  std::vector<std::string> words{"sandsim"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  words.insert(words.end(), {"--progress-fd", std::to_string(progress_descriptor)});
  std::vector<char*> pointers;
  for (std::string& word : words) {
    pointers.push_back(word.data());
  }
  pointers.push_back(nullptr);
  const pid_t parent = getpid();
  pid_ = fork();
  if (pid_ == 0) {
    become_case(executable.c_str(), pointers.data(), parent, errors_.descriptor(), progress_.descriptor(),
                lock.descriptor());
    _exit(127);
  }
  if (pid_ < 0) {
    fail_to_start();
  }
}

CaseProcess::~CaseProcess() {
  if (!exit_code_) {
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
}

void CaseProcess::send(int signal_number) const {
  if (!exit_code_) {
    kill(pid_, signal_number);
  }
}

std::optional<int> CaseProcess::poll() {
  int status = 0;
  if (!exit_code_ && waitpid(pid_, &status, WNOHANG) == pid_) {
    exit_code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  return exit_code_;
}

CaseProgress CaseProcess::progress() const {
  CaseProgress progress;
  std::istringstream(progress_.text()) >> progress.time >> progress.end;
  return progress;
}

}  // namespace sandsim::cli
