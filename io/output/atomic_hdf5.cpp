#include "io/output/atomic_hdf5.hpp"

#include <fmt/format.h>

#include "io/output/atomic_file.hpp"
#include "solver/errors.hpp"

namespace sandsim {

void write_hdf5_atomically(const std::filesystem::path& path, const std::function<void(hid_t file)>& fill) {
  const std::filesystem::path temporary = path.string() + ".tmp";
  try {
    const hdf5::Session session;
    hdf5::Handle file = hdf5::create_file(temporary);
    fill(file.id());
    hdf5::require(H5Fflush(file.id(), H5F_SCOPE_GLOBAL), "write " + temporary.string());
    file.close("close " + temporary.string());
    sync_file(temporary);
    rename_durably(temporary, path);
  } catch (const hdf5::Failure& failure) {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    throw OutputError(fmt::format("{}: {}", path.string(), failure.what()));
  } catch (...) {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    throw;
  }
}

}  // namespace sandsim
