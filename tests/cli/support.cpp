#include "support.hpp"

#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "cli/app.hpp"

namespace sandsim::test {

namespace fs = std::filesystem;

TemporaryDirectory::TemporaryDirectory() {
  std::string name = (fs::temp_directory_path() / "sandsim_cli_XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) {
    throw std::runtime_error("no temporary directory");
  }
  path_ = name;
}

TemporaryDirectory::~TemporaryDirectory() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

Outcome call(const std::vector<std::string>& args) {
  std::ostringstream out, err;
  const int code = cli::run_app(args, out, err);
  return {code, out.str(), err.str()};
}

Process::Process(const std::vector<std::string>& args, const fs::path& folder, const std::function<void()>& prepare)
    : folder_(folder) {
  std::vector<std::string> words{SANDSIM_BINARY_DIR "/bin/sandsim"};
  words.insert(words.end(), args.begin(), args.end());
  std::vector<char*> pointers;
  for (std::string& word : words) {
    pointers.push_back(word.data());
  }
  pointers.push_back(nullptr);
  const std::string out = (folder / "stdout").string();
  const std::string err = (folder / "stderr").string();
  pid_ = fork();
  if (pid_ == 0) {
    dup2(open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
    dup2(open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
    // Test runners may have started us with signals ignored, which a child inherits.
    signal(SIGINT, SIG_DFL);
    signal(SIGTERM, SIG_DFL);
    if (prepare) {
      prepare();
    }
    execv(pointers[0], pointers.data());
    _exit(127);
  }
  if (pid_ < 0) {
    throw std::runtime_error("cannot fork");
  }
}

Process::~Process() {
  if (!ended_) {
    kill(pid_, SIGKILL);
    waitpid(pid_, &status_, 0);
  }
}

void Process::send(int signal_number) const {
  kill(pid_, signal_number);
}

bool Process::running() {
  if (!ended_ && waitpid(pid_, &status_, WNOHANG) == pid_) {
    ended_ = true;
  }
  return !ended_;
}

Outcome Process::wait() {
  if (!ended_) {
    waitpid(pid_, &status_, 0);
    ended_ = true;
  }
  const int code = WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_);
  return {code, read_text(folder_ / "stdout"), read_text(folder_ / "stderr")};
}

bool wait_until(const std::function<bool()>& condition) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) {
      return false;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

void write_text(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  std::ofstream(path) << text;
}

std::string read_text(const fs::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string small_scene() {
  return R"(title: Small dam break
grid: {cells: [40, 1], spacing: 1 cm}
gravity: 9.8 m/s^2
terrain: {type: flat}
sand:
  friction_angle: 30 deg
  hbar: {policy: full}
  initial:
    - {type: box, from: [0 m, 0 m], to: [10 cm, 1 cm], depth: 5 cm}
time: {mode: adaptive, end: 2 s, frame_interval: 20 ms, stop_at_rest: true}
numerics: {scheme: balanced, order: 2, precision: float32}
)";
}

namespace {

std::string column_scene(const std::string& end) {
  return R"(title: Column in small steps
grid: {cells: [48, 48], spacing: 1 cm}
terrain: {type: plane, inclination: 5 deg}
sand:
  friction_angle: 25 deg
  hbar: {policy: truncated, scale: 0.8, cap: 5 cm}
  initial: {type: column, center: [20 cm, 24 cm], radius: 10 cm, depth: 20 cm}
  sources: [{center: [20 cm, 10 cm], radius: 3 cm, rate: 1 cm^3/s, end: )" +
         end + R"(}]
time: {mode: adaptive, courant: 0.02, end: )" +
         end + R"(, frame_interval: 10 ms}
output: {fields: [depth, velocity], maxima: true, probes: [{name: foot, at: [35 cm, 24 cm]}]}
)";
}

}  // namespace

std::string long_scene() {
  return column_scene("500 ms");
}

std::string endless_scene() {
  return column_scene("1000 s");
}

}  // namespace sandsim::test
