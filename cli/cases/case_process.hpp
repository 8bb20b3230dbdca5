// One case as a process of its own: HDF5 is not thread-safe, a crash stays in its case, and a case has the bits of a
// single run.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/output/file_lock.hpp"

namespace sandsim::cli {

/// How far a run has come. [s] simulated
struct CaseProgress {
  double time = 0.0;
  double end = 0.0;
};

/// A file that no folder holds; closed with this.
class AnonymousFile {
 public:
  /// Throws DeviceError if there is none to be had.
  explicit AnonymousFile(const char* name);
  ~AnonymousFile();
  AnonymousFile(const AnonymousFile&) = delete;
  AnonymousFile& operator=(const AnonymousFile&) = delete;

  int descriptor() const { return descriptor_; }
  /// Its first 64 KiB.
  std::string text() const;

 private:
  int descriptor_;
};

/// The lock of a case's directory, "case.lock", tried once: held while a process works on the case. Makes the directory
/// if need be. Throws OutputError.
FileLock lock_case(const std::filesystem::path& directory);

/// A sandsim command as a child process in a process group of its own, so that Ctrl-C reaches it through its parent
/// only. When the parent dies, however suddenly, the child gets SIGTERM and writes its checkpoint. It is killed if it
/// still runs when this goes.
class CaseProcess {
 public:
  /// Starts EXECUTABLE ARGUMENTS --progress-fd N. The lock passes to the child. Throws DeviceError.
  CaseProcess(const std::filesystem::path& executable, const std::vector<std::string>& arguments, const FileLock& lock);
  ~CaseProcess();
  CaseProcess(const CaseProcess&) = delete;
  CaseProcess& operator=(const CaseProcess&) = delete;

  void send(int signal_number) const;
  /// Its exit code once it has ended; 128 + signal if a signal killed it, as a shell has it.
  std::optional<int> poll();
  CaseProgress progress() const;
  /// What it has said on standard error.
  std::string error_text() const { return errors_.text(); }

 private:
  AnonymousFile errors_;
  AnonymousFile progress_;
  pid_t pid_ = -1;
  std::optional<int> exit_code_;
};

}  // namespace sandsim::cli
