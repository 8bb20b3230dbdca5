// Every file of tests/bad_scenes is a scene with a problem; the .expected file beside it holds the exit code and the
// whole message. SANDSIM_REWRITE_EXPECTED=1 writes these files anew, to be read before they are committed.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "io/scene/scene_reader.hpp"
#include "solver/errors.hpp"
#include "tests/support/catch.hpp"

using namespace sandsim;

namespace {

std::string outcome(const std::filesystem::path& scene) {
  try {
    read_scene(scene);
  } catch (const Error& error) {
    return "exit code " + std::to_string(static_cast<int>(error.code())) + '\n' + error.what() + '\n';
  }
  return "no error\n";
}

std::string content(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

/// Messages name files as they are given: relative to the folder of the bad scenes.
class InFolder {
 public:
  explicit InFolder(const std::filesystem::path& folder) : before_(std::filesystem::current_path()) {
    std::filesystem::current_path(folder);
  }
  ~InFolder() { std::filesystem::current_path(before_); }
  InFolder(const InFolder&) = delete;
  InFolder& operator=(const InFolder&) = delete;

 private:
  std::filesystem::path before_;
};

}  // namespace

TEST_CASE("every bad scene gives its expected message and exit code") {
  const InFolder folder(SANDSIM_SOURCE_DIR "/tests/bad_scenes");
  const bool rewrite = std::getenv("SANDSIM_REWRITE_EXPECTED") != nullptr;
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(".")) {
    if (entry.path().extension() != ".yaml") continue;
    const std::filesystem::path scene = entry.path().filename();
    std::filesystem::path expected = scene;
    expected.replace_extension(".expected");
    CAPTURE(scene);
    const std::string message = outcome(scene);
    if (rewrite) std::ofstream(expected) << message;
    CHECK(message != "no error\n");
    CHECK(message == content(expected));
    ++count;
  }
  CHECK(count >= 50);
}
