#include "io/output/file_reserve.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>
#include <vector>

namespace sandsim {
namespace {

using hdf5::Handle;
using hdf5::require;

// A batch is at most this long, so that a finished file does not carry more that was never used. [bytes]
constexpr std::int64_t batch_bytes = 4 << 20;
constexpr std::int64_t most_frames_in_a_batch = 64;
// A compact data set lies in its object header, which may hold 64 KB. [bytes]
constexpr std::int64_t largest_compact = 60000;
// A node of the index of a chunked data set (version 1 B-tree, rank 32: 64 entries of 8 + 8 (rank + 1) + 8 bytes).
constexpr std::int64_t node_bytes = 3200;
constexpr std::int64_t node_entries = 32;
// Object headers of the data sets without a name, and what the library rounds up. [bytes]
constexpr std::int64_t overhead_bytes = 64 << 10;

/// A data set without a name; its space is free again once it is closed.
Handle create_nameless(hid_t file, std::int64_t bytes, H5D_layout_t layout) {
  const std::string tried = "reserve room in the file";
  const auto size = static_cast<hsize_t>(bytes);
  const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose, tried);
  const Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, tried);
  require(H5Pset_layout(properties.id(), layout), tried);
  require(H5Pset_alloc_time(properties.id(), H5D_ALLOC_TIME_EARLY), tried);
  if (layout != H5D_COMPACT) require(H5Pset_fill_time(properties.id(), H5D_FILL_TIME_NEVER), tried);
  return Handle(H5Dcreate_anon(file, H5T_NATIVE_UCHAR, space.id(), properties.id(), H5P_DEFAULT), H5Dclose, tried);
}

haddr_t end_of(hid_t file) {
  haddr_t end = 0;
  require(H5Fget_eoa(file, &end), "get the end of the file");
  return end;
}

/// Data sets of which the last lies at the end of the file. Small ones may be put into gaps: those are filled as well.
std::vector<Handle> create_at_end(hid_t file) {
  std::vector<Handle> created;
  for (std::int64_t bytes = 64;; bytes *= 2) {
    const haddr_t end = end_of(file);
    created.push_back(create_nameless(file, bytes, H5D_CONTIGUOUS));
    const haddr_t offset = H5Dget_offset(created.back().id());
    if (offset != HADDR_UNDEF && offset >= end) return created;
  }
}

/// A file that is shorter than its own superblock says does not open: so its length comes first.
void lengthen_on_disk(hid_t file) {
  void* descriptor = nullptr;
  require(H5Fget_vfd_handle(file, H5P_DEFAULT, &descriptor), "get the file's descriptor");
  if (::ftruncate(*static_cast<int*>(descriptor), static_cast<off_t>(end_of(file))) != 0) {
    throw hdf5::Failure(fmt::format("could not lengthen the file ({})", std::strerror(errno)));
  }
}

}  // namespace

FileReserve::FileReserve(hid_t file, const SeriesGrowth& growth)
    : file_(file),
      growth_(growth),
      batch_(std::clamp<std::int64_t>(batch_bytes / (growth.field_bytes + 1), 1, most_frames_in_a_batch)) {}

std::int64_t FileReserve::raw_bytes() const {
  return batch_ * growth_.field_bytes + growth_.number_bytes;
}

std::int64_t FileReserve::metadata_bytes() const {
  // Every node of an index is at least half full when the next one is added; the first frame begins all of them.
  const std::int64_t nodes = batch_ * growth_.field_chunks / node_entries + growth_.field_count;
  return (nodes + (first_ ? growth_.number_count : 0)) * node_bytes;
}

std::int64_t FileReserve::bytes_to_add() const {
  return frames_left_ > 0 ? 0 : raw_bytes() + metadata_bytes() + overhead_bytes;
}

void FileReserve::prepare_frame() {
  if (frames_left_ > 0) {
    --frames_left_;
    return;
  }
  std::vector<Handle> reserve;
  reserve.push_back(create_nameless(file_, raw_bytes(), H5D_CONTIGUOUS));
  for (std::int64_t left = metadata_bytes(); left > 0; left -= largest_compact) {
    reserve.push_back(create_nameless(file_, std::min(left, largest_compact), H5D_COMPACT));
  }
  std::vector<Handle> end = create_at_end(file_);
  lengthen_on_disk(file_);
  require(H5Fflush(file_, H5F_SCOPE_LOCAL), "reserve room in the file");
  reserve.clear();
  end_ = std::move(end);
  frames_left_ = batch_ - 1;
  first_ = false;
}

}  // namespace sandsim
