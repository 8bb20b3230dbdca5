// Room inside an HDF5 file for frames to come. Internal to io/output.
#pragma once

#include <cstdint>
#include <vector>

#include "io/hdf5/hdf5.hpp"

namespace sandsim {

/// By how much a series grows: upper bounds.
struct SeriesGrowth {
  std::int64_t field_bytes = 0;   // fields and other chunks that every frame adds
  std::int64_t field_chunks = 0;  // their number
  std::int64_t field_count = 0;   // variables that they belong to
  std::int64_t number_bytes = 0;  // one chunk of each variable that gathers numbers over many frames
  std::int64_t number_count = 0;  // such variables
};

/// The library writes where a new block lies before it writes that the file has become longer. A run killed in between
/// would leave a file whose newest blocks, and with them whole variables, cannot be read. So the file is made longer
/// first, by data sets without a name; they are then freed, and the frames take their place.
class FileReserve {
 public:
  /// `file` stays open and owned by the caller.
  FileReserve(hid_t file, const SeriesGrowth& growth);

  /// Bytes by which the next call of prepare_frame() makes the file longer.
  std::int64_t bytes_to_add() const;

  /// Makes sure that the next frame fits. All that belongs to earlier frames must have been flushed.
  void prepare_frame();

 private:
  std::int64_t raw_bytes() const;
  std::int64_t metadata_bytes() const;

  hid_t file_;
  SeriesGrowth growth_;
  std::int64_t batch_;            // frames that are reserved at a time
  std::int64_t frames_left_ = 0;  // for which there is room
  bool first_ = true;
  std::vector<hdf5::Handle> end_;  // keeps the file from shrinking when the reserve in front of it is freed
};

}  // namespace sandsim
