#include "io/hdf5/hdf5.hpp"

#include <fmt/format.h>

namespace sandsim::hdf5 {
namespace {

std::mutex& library_mutex() {
  static std::mutex mutex;
  return mutex;
}

herr_t keep_innermost(unsigned depth, const H5E_error2_t* error, void* text) {
  if (depth == 0 && error->desc != nullptr) *static_cast<std::string*>(text) = error->desc;
  return 0;
}

std::string innermost_reason() {
  std::string reason;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_innermost, &reason);
  H5Eclear2(H5E_DEFAULT);
  return reason.empty() ? "the HDF5 library gave no reason" : reason;
}

[[noreturn]] void fail(std::string_view tried) {
  throw Failure(fmt::format("could not {} ({})", tried, innermost_reason()));
}

Handle property_list(hid_t kind) {
  return Handle(H5Pcreate(kind), H5Pclose, "create a property list");
}

Handle file_access(bool writable) {
  Handle access = property_list(H5P_FILE_ACCESS);
  // Closing the file closes what is open in it, so that nothing is left behind after an error.
  require(H5Pset_fclose_degree(access.id(), H5F_CLOSE_STRONG), "set up the file's closing");
  // The oldest form of every part: its headers carry no checksum, which a run that is killed between two pages of a
  // header would leave wrong. Everybody can read it.
  require(H5Pset_libver_bounds(access.id(), H5F_LIBVER_EARLIEST, H5F_LIBVER_V110), "set the version of the format");
  // Blocks are put where there is room, so that FileReserve has a say in it.
  require(H5Pset_small_data_block_size(access.id(), 0), "set up the file's layout");
  require(H5Pset_meta_block_size(access.id(), 0), "set up the file's layout");
#if H5_VERSION_GE(1, 10, 7)
  // Readers may look at a run that goes on. Some network file systems have no locks; the run must not fail for that.
  require(H5Pset_file_locking(access.id(), writable, true), "set up file locks");
#else
  static_cast<void>(writable);
#endif
  return access;
}

Handle text_type(std::size_t length) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "create a text type");
  require(H5Tset_size(type.id(), length == 0 ? 1 : length), "size a text type");
  require(H5Tset_strpad(type.id(), H5T_STR_NULLPAD), "pad a text type");
  require(H5Tset_cset(type.id(), H5T_CSET_UTF8), "make a text type UTF-8");
  return type;
}

void write_scalar_attribute(hid_t object, const std::string& name, hid_t type, const void* value) {
  const std::string tried = "write the attribute " + name;
  if (H5Aexists(object, name.c_str()) > 0) require(H5Adelete(object, name.c_str()), tried);
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, tried);
  const Handle attribute(H5Acreate2(object, name.c_str(), type, space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose, tried);
  require(H5Awrite(attribute.id(), type, value), tried);
}

void read_scalar_attribute(hid_t object, const std::string& name, hid_t type, void* value) {
  const std::string tried = "read the attribute " + name;
  const Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose, tried);
  const Handle space(H5Aget_space(attribute.id()), H5Sclose, tried);
  if (H5Sget_simple_extent_npoints(space.id()) != 1) throw Failure("the attribute " + name + " is not a single value");
  require(H5Aread(attribute.id(), type, value), tried);
}

struct Spaces {
  Handle memory;
  Handle file;
};

Spaces select(hid_t dataset, const Block& block, std::string_view tried) {
  Spaces spaces;
  spaces.file = Handle(H5Dget_space(dataset), H5Sclose, tried);
  require(
      H5Sselect_hyperslab(spaces.file.id(), H5S_SELECT_SET, block.start.data(), nullptr, block.count.data(), nullptr),
      tried);
  spaces.memory =
      Handle(H5Screate_simple(static_cast<int>(block.count.size()), block.count.data(), nullptr), H5Sclose, tried);
  return spaces;
}

std::string path_of(hid_t object) {
  char name[256] = {};
  return H5Iget_name(object, name, sizeof name) > 0 ? name + (name[0] == '/' ? 1 : 0) : "a data set";
}

}  // namespace

Session::Session() : lock_(library_mutex()) {
  // A file that could not be flushed would send the library round in circles at exit. All files are closed by then.
  static const herr_t once = H5dont_atexit();
  static_cast<void>(once);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

void require(herr_t status, std::string_view tried) {
  if (status < 0) fail(tried);
}

Handle::Handle(hid_t id, Close closer, std::string_view tried) : id_(id), close_(closer) {
  if (id < 0) fail(tried);
}

Handle& Handle::operator=(Handle&& other) noexcept {
  if (this != &other) {
    reset();
    id_ = std::exchange(other.id_, H5I_INVALID_HID);
    close_ = other.close_;
  }
  return *this;
}

void Handle::close(std::string_view tried) {
  if (id_ >= 0) require(close_(std::exchange(id_, H5I_INVALID_HID)), tried);
}

void Handle::reset() {
  if (id_ >= 0) close_(std::exchange(id_, H5I_INVALID_HID));
}

Handle create_file(const std::filesystem::path& path) {
  const Handle creation = property_list(H5P_FILE_CREATE);
  const unsigned order = H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED;
  require(H5Pset_link_creation_order(creation.id(), order), "keep the order of the data sets");
  require(H5Pset_attr_creation_order(creation.id(), order), "keep the order of the attributes");
  const Handle access = file_access(true);
  return Handle(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation.id(), access.id()), H5Fclose, "create the file");
}

Handle open_file(const std::filesystem::path& path, bool writable) {
  const Handle access = file_access(writable);
  const unsigned mode = writable ? H5F_ACC_RDWR : H5F_ACC_RDONLY;
  Handle file(H5Fopen(path.c_str(), mode, access.id()), H5Fclose, "open the file");
  if (writable) require(H5Fincrement_filesize(file.id(), 0), "take the file at its length");
  return file;
}

Handle open_dataset(hid_t file, const std::string& name) {
  return Handle(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose, "open " + name);
}

bool exists(hid_t file, const std::string& name) {
  return H5Lexists(file, name.c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::string> dataset_names(hid_t file) {
  std::vector<std::string> names;
  const auto add = [](hid_t, const char* name, const H5L_info_t*, void* list) -> herr_t {
    static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    return 0;
  };
  hsize_t position = 0;
  if (H5Literate(file, H5_INDEX_CRT_ORDER, H5_ITER_INC, &position, add, &names) < 0) {
    // Files of other programs may not keep the order of creation.
    names.clear();
    position = 0;
    require(H5Literate(file, H5_INDEX_NAME, H5_ITER_INC, &position, add, &names), "list the data sets");
  }
  std::erase_if(names, [file](const std::string& name) {
    const hid_t object = H5Oopen(file, name.c_str(), H5P_DEFAULT);
    if (object < 0) return true;
    const bool dataset = H5Iget_type(object) == H5I_DATASET;
    H5Oclose(object);
    return !dataset;
  });
  return names;
}

std::vector<hsize_t> extent(hid_t dataset) {
  const Handle space(H5Dget_space(dataset), H5Sclose, "get the shape of " + path_of(dataset));
  const int rank = H5Sget_simple_extent_ndims(space.id());
  require(rank, "get the shape of " + path_of(dataset));
  std::vector<hsize_t> lengths(static_cast<std::size_t>(rank));
  if (rank > 0) require(H5Sget_simple_extent_dims(space.id(), lengths.data(), nullptr), "get a shape");
  return lengths;
}

bool is_numeric(hid_t dataset) {
  const Handle type(H5Dget_type(dataset), H5Tclose, "get the type of " + path_of(dataset));
  const H5T_class_t kind = H5Tget_class(type.id());
  return kind == H5T_FLOAT || kind == H5T_INTEGER;
}

std::size_t element_size(hid_t dataset) {
  const Handle type(H5Dget_type(dataset), H5Tclose, "get the type of " + path_of(dataset));
  return H5Tget_size(type.id());
}

void write(hid_t dataset, hid_t memory_type, const void* values, const Block& block) {
  const std::string tried = "write " + path_of(dataset);
  if (block.start.empty()) {
    require(H5Dwrite(dataset, memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), tried);
  } else {
    const Spaces spaces = select(dataset, block, tried);
    require(H5Dwrite(dataset, memory_type, spaces.memory.id(), spaces.file.id(), H5P_DEFAULT, values), tried);
  }
}

void read(hid_t dataset, hid_t memory_type, void* values, const Block& block) {
  const std::string tried = "read " + path_of(dataset);
  if (block.start.empty()) {
    require(H5Dread(dataset, memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), tried);
  } else {
    const Spaces spaces = select(dataset, block, tried);
    require(H5Dread(dataset, memory_type, spaces.memory.id(), spaces.file.id(), H5P_DEFAULT, values), tried);
  }
}

void write_attribute(hid_t object, const std::string& name, const std::string& text) {
  const Handle type = text_type(text.size());
  write_scalar_attribute(object, name, type.id(), text.c_str());
}

void write_attribute(hid_t object, const std::string& name, double number) {
  write_scalar_attribute(object, name, H5T_NATIVE_DOUBLE, &number);
}

void write_attribute(hid_t object, const std::string& name, float number) {
  write_scalar_attribute(object, name, H5T_NATIVE_FLOAT, &number);
}

void write_attribute(hid_t object, const std::string& name, std::int64_t number) {
  write_scalar_attribute(object, name, H5T_NATIVE_INT64, &number);
}

std::optional<std::string> read_text_attribute(hid_t object, const std::string& name) {
  if (H5Aexists(object, name.c_str()) <= 0) return std::nullopt;
  const Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose, "open the attribute " + name);
  const Handle type(H5Aget_type(attribute.id()), H5Tclose, "get the type of the attribute " + name);
  if (H5Tget_class(type.id()) != H5T_STRING || H5Tis_variable_str(type.id()) > 0) return std::nullopt;
  std::string text(H5Tget_size(type.id()), '\0');
  read_scalar_attribute(object, name, type.id(), text.data());
  return text.substr(0, text.find('\0'));
}

double read_double_attribute(hid_t object, const std::string& name) {
  double number = 0.0;
  read_scalar_attribute(object, name, H5T_NATIVE_DOUBLE, &number);
  return number;
}

std::int64_t read_integer_attribute(hid_t object, const std::string& name) {
  std::int64_t number = 0;
  read_scalar_attribute(object, name, H5T_NATIVE_INT64, &number);
  return number;
}

}  // namespace sandsim::hdf5
