// The STL reader either returns a whole mesh or throws InputError, whatever the bytes.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "io/mesh/read_mesh.hpp"
#include "solver/errors.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const sandsim::objects::TriangleMesh mesh =
        sandsim::read_stl(std::string_view(reinterpret_cast<const char*>(data), size), "fuzz.stl");
    if (mesh.triangles.empty()) std::abort();
    for (const auto& p : mesh.vertices) {
      if (!(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z))) std::abort();
    }
    for (const auto& triangle : mesh.triangles) {
      for (const std::uint32_t corner : triangle) {
        if (corner >= mesh.vertices.size()) std::abort();
      }
    }
  } catch (const sandsim::InputError&) {
  }
  return 0;
}
