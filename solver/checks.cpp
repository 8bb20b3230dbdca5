#include "solver/checks.hpp"

namespace sandsim {

std::vector<Issue> check(const Scene&) {
  return {};
}

}  // namespace sandsim
