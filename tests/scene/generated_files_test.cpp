// The schema and the reference page are committed, so that editors and readers need not build the program.
#include <fstream>
#include <sstream>

#include "io/scene/format_reference.hpp"
#include "io/scene/json_schema.hpp"
#include "tests/support/catch.hpp"

namespace {

std::string content(const std::string& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

}  // namespace

TEST_CASE("the committed schema is the one that the program writes") {
  // If not: sandsim schema > scenes/scene.schema.json
  CHECK(content(SANDSIM_SOURCE_DIR "/scenes/scene.schema.json") == sandsim::json_schema());
}

TEST_CASE("the committed reference page is the one that the program writes") {
  // If not: sandsim schema --reference > scenes/FORMAT.md
  CHECK(content(SANDSIM_SOURCE_DIR "/scenes/FORMAT.md") == sandsim::format_reference());
}
