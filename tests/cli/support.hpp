// What the tests of the command line share: folders, scenes, calls in-process and as a process of its own.
#pragma once

#include <sys/resource.h>
#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace sandsim::test {

/// A new empty folder that goes with all it holds.
class TemporaryDirectory {
 public:
  TemporaryDirectory();
  ~TemporaryDirectory();
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

struct Outcome {
  int code = 0;
  std::string out;
  std::string err;
};

/// run_app() with these arguments.
Outcome call(const std::vector<std::string>& args);

/// The sandsim executable as a child process. Its output goes to files in `folder`.
class Process {
 public:
  /// `prepare` runs in the child before the program starts, for limits.
  Process(const std::vector<std::string>& args, const std::filesystem::path& folder,
          const std::function<void()>& prepare = {});
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  void send(int signal_number) const;
  bool running();
  /// Waits for the end. The code is 128 + signal if a signal killed it, as a shell has it.
  Outcome wait();

 private:
  std::filesystem::path folder_;
  pid_t pid_ = -1;
  bool ended_ = false;
  int status_ = 0;
};

/// Waits up to a minute until `condition` holds; false if it never did.
bool wait_until(const std::function<bool()>& condition);

void write_text(const std::filesystem::path& path, const std::string& text);
std::string read_text(const std::filesystem::path& path);
bool contains(const std::string& text, const std::string& part);

/// A dam break on 40 x 1 cells that takes a few milliseconds.
std::string small_scene();
/// A column that collapses beside a source, on 48 x 48 cells, in some 6,000 steps and 50 frames: a second or so.
std::string long_scene();
/// The same for so long that no test waits for its end.
std::string endless_scene();

}  // namespace sandsim::test
