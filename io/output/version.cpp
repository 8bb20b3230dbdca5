#include "io/output/version.hpp"

#include "sandsim_version.h"

namespace sandsim {

std::string version() {
  return SANDSIM_VERSION;
}

std::string commit() {
  return SANDSIM_COMMIT;
}

std::string source_line() {
  return "sandsim " + version() + " (commit " + commit() + ")";
}

}  // namespace sandsim
