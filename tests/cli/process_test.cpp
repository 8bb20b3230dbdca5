// sandsim as a process: signals, limits and sudden death.
#include <signal.h>
#include <unistd.h>

#include <cstdio>

#include "cli/signals.hpp"
#include "series_values.hpp"
#include "support.hpp"
#include "tests/support/catch.hpp"

using namespace sandsim::test;
namespace fs = std::filesystem;

namespace {

struct Workplace {
  explicit Workplace(const std::string& text) { write_text(scene, text); }

  std::vector<std::string> arguments(const fs::path& directory, std::vector<std::string> more = {}) const {
    std::vector<std::string> args{"run", scene.string(), "-o", directory.string(), "--threads", "1"};
    args.insert(args.end(), more.begin(), more.end());
    return args;
  }

  TemporaryDirectory folder;
  fs::path scene = folder / "scene.yaml";
  fs::path results = folder / "results";
  fs::path partial = results / "series.h5.partial";
};

std::size_t frame_count(const fs::path& series) {
  const auto values = series_values(series);
  const auto time = values.find("time");
  return time == values.end() ? 0 : time->second.size() / sizeof(double);
}

/// Waits until the series has been written to a few times, so that a signal comes in the middle of the run. (Looking
/// into a file that another process writes is left to the readers' own tests.)
bool wait_for_frames(Process& process, const fs::path& partial) {
  int changes = 0;
  fs::file_time_type last{};
  return wait_until([&] {
    std::error_code not_there;
    const fs::file_time_type now = fs::last_write_time(partial, not_there);
    if (!not_there && now != last) {
      last = now;
      ++changes;
    }
    return changes > 4 || !process.running();
  });
}

}  // namespace

TEST_CASE("the first signal is taken and the second one kills") {
  const sandsim::cli::SignalGuard guard;
  CHECK_FALSE(guard.interrupted());
  raise(SIGTERM);
  CHECK(guard.interrupted());
  CHECK(std::string(guard.name()) == "SIGTERM");
  for (const int ending : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction now {};
    sigaction(ending, nullptr, &now);
    CHECK(now.sa_handler == SIG_DFL);
  }
}

TEST_CASE("a signal that was ignored stays ignored") {
  struct sigaction ignore {
  }, before{}, now{};
  ignore.sa_handler = SIG_IGN;
  sigaction(SIGHUP, &ignore, &before);
  {
    const sandsim::cli::SignalGuard guard;
    sigaction(SIGHUP, nullptr, &now);
    CHECK(now.sa_handler == SIG_IGN);
  }
  sigaction(SIGHUP, &before, nullptr);
}

TEST_CASE("SIGTERM and SIGINT end a run with a checkpoint and exit code 130") {
  for (const int signal_number : {SIGTERM, SIGINT}) {
    const Workplace place(endless_scene());
    Process process(place.arguments(place.results), place.folder.path());
    REQUIRE(wait_for_frames(process, place.partial));
    process.send(signal_number);
    const Outcome outcome = process.wait();
    INFO(outcome.err);
    CHECK(outcome.code == 130);
    CHECK(contains(outcome.err, "--resume"));
    CHECK(fs::exists(place.results / "checkpoint.h5"));
    CHECK(fs::exists(place.partial));
    CHECK_FALSE(fs::exists(place.results / "series.h5"));
    CHECK(contains(read_text(place.results / "run.json"), "\"exit_code\": 130"));
    CHECK(call({"info", place.results.string()}).code == 0);
  }
}

TEST_CASE("a run that is interrupted again and again gives the same bits as one that is not") {
  for (const char* precision : {"float32", "float64"}) {
    const Workplace place(long_scene());
    const fs::path whole = place.folder / "whole";
    REQUIRE(Process(place.arguments(whole, {"--precision", precision}), place.folder.path()).wait().code == 0);
    int interruptions = 0;
    std::vector<std::string> more{"--precision", precision};
    Outcome outcome;
    do {
      Process process(place.arguments(place.results, more), place.folder.path());
      if (interruptions < 4) {
        wait_for_frames(process, place.partial);
        process.send(SIGTERM);
      }
      outcome = process.wait();
      more = {"--precision", precision, "--resume"};
    } while (outcome.code == 130 && ++interruptions < 100);
    INFO(outcome.err);
    CHECK(outcome.code == 0);
    CHECK(interruptions > 0);
    CHECK(frame_count(place.results / "series.h5") == 51);
    CHECK(differing_values(whole / "series.h5", place.results / "series.h5") == std::vector<std::string>{});
    CHECK_FALSE(fs::exists(place.results / "checkpoint.h5"));
    CHECK_FALSE(fs::exists(place.partial));
  }
}

TEST_CASE("a checkpoint of another scene is refused") {
  const Workplace place(endless_scene());
  CHECK(Process(place.arguments(place.results, {"--max-wall", "00:00:01"}), place.folder.path()).wait().code == 7);
  std::vector<std::string> args = place.arguments(place.results, {"--resume", "--set", "gravity=9 m/s^2"});
  const Outcome outcome = call(args);
  CHECK(outcome.code == 3);
  CHECK(contains(outcome.err, "scene"));
}

TEST_CASE("the wall clock limit ends a run with a checkpoint and exit code 7") {
  const Workplace place(endless_scene());
  const Outcome outcome =
      Process(place.arguments(place.results, {"--max-wall", "00:00:01"}), place.folder.path()).wait();
  INFO(outcome.err);
  CHECK(outcome.code == 7);
  CHECK(contains(outcome.err, "--resume"));
  CHECK(fs::exists(place.results / "checkpoint.h5"));
  CHECK(contains(read_text(place.results / "run.json"), "\"exit_code\": 7"));
}

TEST_CASE("a run that is killed leaves frames that can be read") {
  const Workplace place(endless_scene());
  Process process(place.arguments(place.results), place.folder.path());
  REQUIRE(wait_for_frames(process, place.partial));
  process.send(SIGKILL);
  CHECK(process.wait().code == 128 + SIGKILL);
  CHECK(frame_count(place.partial) > 0);
  CHECK(call({"info", place.results.string()}).code == 0);
  const Outcome resumed = call(place.arguments(place.results, {"--resume"}));
  CHECK(resumed.code == 3);
  CHECK(contains(resumed.err, "--overwrite"));
}

TEST_CASE("a full disk exits 6 and leaves no series that looks whole") {
  const Workplace place(endless_scene());
  const auto limit = [] {
    const rlimit bytes{3'000'000, 3'000'000};
    setrlimit(RLIMIT_FSIZE, &bytes);
  };
  const Outcome outcome = Process(place.arguments(place.results), place.folder.path(), limit).wait();
  INFO(outcome.err);
  CHECK(outcome.code == 6);
  CHECK(outcome.err.starts_with("sandsim: error: "));
  CHECK_FALSE(fs::exists(place.results / "series.h5"));
  CHECK(contains(read_text(place.results / "run.json"), "\"exit_code\": 6"));
  CHECK(call({"info", place.results.string()}).code == 0);
}

TEST_CASE("standard error that is no terminal shows no progress") {
  const Workplace place(long_scene());
  const Outcome outcome = Process(place.arguments(place.results), place.folder.path()).wait();
  CHECK(outcome.code == 0);
  CHECK(outcome.err.empty());
}

TEST_CASE("standard output that cannot be written is an output error") {
  const Workplace place(small_scene());
  const auto full = [] {
    if (freopen("/dev/full", "w", stdout) == nullptr) {
      _exit(127);
    }
  };
  CHECK(Process(place.arguments(place.results), place.folder.path(), full).wait().code == 6);
}
