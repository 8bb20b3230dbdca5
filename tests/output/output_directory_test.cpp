#include "io/output/output_directory.hpp"

#include <unistd.h>

#include "io/output/atomic_file.hpp"
#include "solver/errors.hpp"
#include "tests/output/fixtures.hpp"
#include "tests/support/catch.hpp"

namespace sandsim::test {
namespace {

namespace fs = std::filesystem;

/// Runs `work` as a user without rights; 6 if it throws an OutputError.
int run_without_rights(const std::function<void()>& work) {
  return run_in_child([&] {
    if (::geteuid() == 0 && ::setuid(65534) != 0) return 1;
    try {
      work();
    } catch (const OutputError&) {
      return 6;
    }
    return 0;
  });
}

}  // namespace

TEST_CASE("A new output directory is made with its parents") {
  const TemporaryDirectory directory;

  const OutputFiles files = prepare_output_directory(directory / "a/b", false, false);

  CHECK(fs::is_directory(directory / "a/b"));
  CHECK(fs::is_empty(directory / "a/b"));
  CHECK(files.series == directory / "a/b/series.h5");
  // An empty one is taken as it is.
  CHECK_NOTHROW(prepare_output_directory(directory / "a/b", false, false));
}

TEST_CASE("An output directory that is not empty is refused and both flags are named") {
  const TemporaryDirectory directory;
  write_text(directory / "notes.txt", "mine");

  const std::string message =
      message_of<OutputError>([&] { prepare_output_directory(directory.path(), false, false); });

  CHECK(message.find("--resume") != std::string::npos);
  CHECK(message.find("--overwrite") != std::string::npos);
}

TEST_CASE("Overwriting removes the files of a run and nothing else") {
  const TemporaryDirectory directory;
  for (const char* name : {"series.h5", "series.h5.partial", "series.xdmf", "run.json", "scene.resolved.yaml",
                           "log.txt", "checkpoint.h5", "checkpoint.h5.tmp"}) {
    write_text(directory / name, "old");
  }
  write_text(directory / "notes.txt", "mine");
  write_text(directory / "other.h5", "mine");

  prepare_output_directory(directory.path(), true, false);

  CHECK(std::distance(fs::directory_iterator(directory.path()), fs::directory_iterator{}) == 2);
  CHECK(read_text(directory / "notes.txt") == "mine");
  CHECK(read_text(directory / "other.h5") == "mine");
}

TEST_CASE("Overwriting does not remove a folder that has the name of a file") {
  const TemporaryDirectory directory;
  fs::create_directories(directory / "run.json/precious");

  CHECK_THROWS_AS(prepare_output_directory(directory.path(), true, false), OutputError);
  CHECK(fs::exists(directory / "run.json/precious"));
}

TEST_CASE("Resuming leaves the directory as it is") {
  const TemporaryDirectory directory;
  write_text(directory / "checkpoint.h5", "old");

  prepare_output_directory(directory.path(), false, true);

  CHECK(read_text(directory / "checkpoint.h5") == "old");
}

TEST_CASE("An output directory that is a file is an output error") {
  const TemporaryDirectory directory;
  write_text(directory / "file", "");
  CHECK_THROWS_AS(prepare_output_directory(directory / "file", true, false), OutputError);
  CHECK_THROWS_AS(prepare_output_directory(directory / "file/below", false, false), OutputError);
}

TEST_CASE("An output directory that cannot be written to is an output error") {
  const TemporaryDirectory directory;
  fs::create_directory(directory / "locked");
  fs::permissions(directory.path(), fs::perms::all);
  fs::permissions(directory / "locked",
                  fs::perms::owner_read | fs::perms::others_read | fs::perms::owner_exec | fs::perms::others_exec);

  CHECK(run_without_rights([&] { prepare_output_directory(directory / "locked", false, false); }) == 6);
  CHECK(run_without_rights([&] { prepare_output_directory(directory / "locked/new", false, false); }) == 6);
  CHECK(run_without_rights([&] { write_file_atomically(directory / "locked/run.json", "{}"); }) == 6);
}

TEST_CASE("A file is replaced as a whole or not at all") {
  const TemporaryDirectory directory;
  write_file_atomically(directory / "run.json", "old");
  write_file_atomically(directory / "run.json", "new");
  CHECK(read_text(directory / "run.json") == "new");
  CHECK_FALSE(fs::exists(directory / "run.json.tmp"));

  CHECK_THROWS_AS(write_file_atomically(directory / "missing/run.json", "x"), OutputError);
  // A device that is always full stands in for a full disk.
  fs::create_symlink("/dev/full", directory / "run.json.tmp");
  const std::string message = message_of<OutputError>([&] { write_file_atomically(directory / "run.json", "newer"); });
  CHECK(message.find("No space left on device") != std::string::npos);
  CHECK(read_text(directory / "run.json") == "new");
}

}  // namespace sandsim::test
