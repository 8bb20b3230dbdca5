#include <dlfcn.h>
#include <fmt/format.h>

#include "io/gis/gis.hpp"
#include "solver/errors.hpp"

namespace sandsim {
namespace {

namespace fs = std::filesystem;

/// Beside the program, in the build folder as where it is installed: PREFIX/bin and PREFIX/lib/sandsim.
fs::path module_path() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  return program.parent_path().parent_path() / "lib" / "sandsim" / "sandsim_gdal.so";
}

Gis& open_module(const std::string& needed_for) {
  const fs::path path = module_path();
  if (!has_gis()) {
    throw InputError(
        fmt::format("{}: needs GDAL, and this sandsim was built without it ({} is missing). Install libgdal-dev and "
                    "build again; ESRI ASCII grids and .npy need no GDAL",
                    needed_for, path.string()));
  }
  // Never closed: GDAL keeps threads and caches that outlive any caller.
  void* const module = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (module == nullptr) {
    throw InputError(
        fmt::format("{}: needs GDAL, whose module cannot be opened ({}). Is the GDAL that sandsim was "
                    "built with still installed?",
                    needed_for, dlerror()));
  }
  using Entry = Gis* (*)();
  const auto entry = reinterpret_cast<Entry>(dlsym(module, "sandsim_gis"));
  if (entry == nullptr) {
    throw InputError(
        fmt::format("{}: {} is no module of this program. Build or install anew", needed_for, path.string()));
  }
  return *entry();
}

}  // namespace

bool has_gis() {
  std::error_code error;
  return fs::exists(module_path(), error);
}

Gis& gis(const std::string& needed_for) {
  static Gis& module = open_module(needed_for);
  return module;
}

}  // namespace sandsim
