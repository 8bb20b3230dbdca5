// Numbers out of bytes.
#pragma once

#include <algorithm>
#include <bit>
#include <cstring>

namespace sandsim {

static_assert(std::endian::native == std::endian::little, "the values are swapped on this assumption");

/// The number whose sizeof(T) bytes start there.
template <typename T>
T load_bytes(const char* bytes, bool big_endian) {
  char item[sizeof(T)];
  std::memcpy(item, bytes, sizeof(T));
  if (big_endian) std::reverse(item, item + sizeof(T));
  T value;
  std::memcpy(&value, item, sizeof(T));
  return value;
}

}  // namespace sandsim
