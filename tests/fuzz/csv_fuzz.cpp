// The CSV readers either return a whole curve or throw InputError, whatever the bytes.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "io/raster/read_csv.hpp"
#include "solver/errors.hpp"

namespace {

void require_curve(const std::vector<double>& x, const std::vector<double>& y) {
  if (x.size() < 2 || x.size() != y.size() || !(x.back() > x.front())) {
    std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const sandsim::Profile profile = sandsim::read_profile_csv(text, "fuzz.csv");
    require_curve(profile.x, profile.depth);
  } catch (const sandsim::InputError&) {
  }
  try {
    const sandsim::FrontCurve front = sandsim::read_front_csv(text, "fuzz.csv");
    require_curve(front.time, front.front);
  } catch (const sandsim::InputError&) {
  }
  try {
    const sandsim::PathTable path = sandsim::read_path_csv(text, "fuzz.csv");
    if (path.time.size() != path.position.size() || path.time.size() < 2) std::abort();
  } catch (const sandsim::InputError&) {
  }
  return 0;
}
