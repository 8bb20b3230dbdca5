// The few HDF5 calls that readers and writers share, with every return value checked. Internal to io.
#pragma once

#include <hdf5.h>

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sandsim::hdf5 {

/// A call of the library that failed: what was tried, and the library's innermost reason (with errno's text).
class Failure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Held by whoever calls the library: one caller at a time, since the library may be built without locks of its own
/// and a checkpoint is written while frames are. Keeps the library from printing to stderr. Not to be nested.
class Session {
 public:
  Session();

 private:
  std::lock_guard<std::mutex> lock_;
};

/// Throws Failure if a call returned an error.
void require(herr_t status, std::string_view tried);

/// Owns an identifier of the library.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);

  Handle() = default;
  /// Throws Failure if `id` is an error.
  Handle(hid_t id, Close closer, std::string_view tried);
  ~Handle() { reset(); }
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
  Handle& operator=(Handle&& other) noexcept;

  hid_t id() const { return id_; }
  explicit operator bool() const { return id_ >= 0; }
  /// Closes and throws Failure if that went wrong. A destructor closes as well, but has to keep silent.
  void close(std::string_view tried);

 private:
  void reset();

  hid_t id_ = H5I_INVALID_HID;
  Close close_ = nullptr;
};

/// Creates a file, replacing one that is there. Links and attributes keep the order in which they are made.
Handle create_file(const std::filesystem::path& path);
/// Opened to be written to, the file is taken to be as long as it is on the disk: a run that was killed may not have
/// written its length.
Handle open_file(const std::filesystem::path& path, bool writable);

Handle open_dataset(hid_t file, const std::string& name);
bool exists(hid_t file, const std::string& name);
/// Names of the data sets in the root group, in the order in which they were made.
std::vector<std::string> dataset_names(hid_t file);
/// Lengths of the dimensions of a data set.
std::vector<hsize_t> extent(hid_t dataset);
/// True if a data set or attribute type holds numbers.
bool is_numeric(hid_t dataset);
std::size_t element_size(hid_t dataset);

template <class Number>
hid_t native_type();
template <>
inline hid_t native_type<float>() {
  return H5T_NATIVE_FLOAT;
}
template <>
inline hid_t native_type<double>() {
  return H5T_NATIVE_DOUBLE;
}
template <>
inline hid_t native_type<std::uint8_t>() {
  return H5T_NATIVE_UINT8;
}
template <>
inline hid_t native_type<std::int64_t>() {
  return H5T_NATIVE_INT64;
}

/// A block of a data set in a file: its first element and its length along each dimension. Empty: all of it.
struct Block {
  std::vector<hsize_t> start;
  std::vector<hsize_t> count;
};
void write(hid_t dataset, hid_t memory_type, const void* values, const Block& block = {});
void read(hid_t dataset, hid_t memory_type, void* values, const Block& block = {});

template <class Number>
std::vector<Number> read_all(hid_t file, const std::string& name) {
  const Handle dataset = open_dataset(file, name);
  hsize_t size = 1;
  for (const hsize_t length : extent(dataset.id())) size *= length;
  std::vector<Number> values(size);
  if (size > 0) read(dataset.id(), native_type<Number>(), values.data());
  return values;
}

void write_attribute(hid_t object, const std::string& name, const std::string& text);
void write_attribute(hid_t object, const std::string& name, double number);
void write_attribute(hid_t object, const std::string& name, float number);
void write_attribute(hid_t object, const std::string& name, std::int64_t number);
/// Empty if there is no such attribute, or it is not a text of fixed length.
std::optional<std::string> read_text_attribute(hid_t object, const std::string& name);
double read_double_attribute(hid_t object, const std::string& name);
std::int64_t read_integer_attribute(hid_t object, const std::string& name);

}  // namespace sandsim::hdf5
