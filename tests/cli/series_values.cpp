#include "series_values.hpp"

#include <hdf5.h>

namespace sandsim::test {

namespace {

std::vector<char> dataset_bytes(hid_t file, const std::string& name) {
  const hid_t set = H5Dopen2(file, name.c_str(), H5P_DEFAULT);
  const hid_t stored = H5Dget_type(set);
  const hid_t type = H5Tget_native_type(stored, H5T_DIR_ASCEND);
  const hid_t space = H5Dget_space(set);
  const auto count = static_cast<std::size_t>(H5Sget_simple_extent_npoints(space));
  std::vector<char> bytes(count * H5Tget_size(type));
  // Strings of variable length would be pointers; their number is all that can be compared here.
  if (H5Tis_variable_str(type) <= 0 && !bytes.empty()) {
    H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data());
  }
  H5Sclose(space);
  H5Tclose(type);
  H5Tclose(stored);
  H5Dclose(set);
  return bytes;
}

}  // namespace

std::map<std::string, std::vector<char>> series_values(const std::filesystem::path& path) {
  std::map<std::string, std::vector<char>> values;
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  if (file < 0) {
    return values;
  }
  H5G_info_t root;
  H5Gget_info(file, &root);
  for (hsize_t k = 0; k < root.nlinks; ++k) {
    char name[256] = "";
    H5Lget_name_by_idx(file, "/", H5_INDEX_NAME, H5_ITER_INC, k, name, sizeof name, H5P_DEFAULT);
    const hid_t object = H5Oopen(file, name, H5P_DEFAULT);
    const bool is_dataset = H5Iget_type(object) == H5I_DATASET;
    H5Oclose(object);
    if (is_dataset) {
      values[name] = dataset_bytes(file, name);
    }
  }
  H5Fclose(file);
  return values;
}

std::vector<std::string> differing_values(const std::filesystem::path& first, const std::filesystem::path& second) {
  const auto a = series_values(first);
  const auto b = series_values(second);
  std::vector<std::string> names;
  for (const auto& [name, bytes] : a) {
    const auto other = b.find(name);
    if (name != "wall_time" && (other == b.end() || other->second != bytes)) {
      names.push_back(name);
    }
  }
  for (const auto& [name, bytes] : b) {
    if (!a.contains(name)) {
      names.push_back(name);
    }
  }
  return names;
}

}  // namespace sandsim::test
