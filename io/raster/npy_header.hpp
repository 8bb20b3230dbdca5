// The header of a .npy file. Format: NumPy, "numpy.lib.format", versions 1.0, 2.0 and 3.0.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace sandsim {

struct NpyHeader {
  char kind = 'f';            // 'f' floating point, 'i' signed, 'u' unsigned
  std::size_t item_size = 8;  // [bytes]
  bool big_endian = false;
  bool fortran_order = false;
  std::vector<std::uint64_t> shape;
  std::size_t data_offset = 0;  // [bytes] where the values start
};

/// Reads the header; `name` stands for the file in errors. Throws InputError.
NpyHeader read_npy_header(std::string_view bytes, const std::string& name);

}  // namespace sandsim
