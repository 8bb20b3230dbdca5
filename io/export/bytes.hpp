// Numbers into bytes.
#pragma once

#include <algorithm>
#include <bit>
#include <cstring>
#include <string>

namespace sandsim {

static_assert(std::endian::native == std::endian::little, "the values are swapped on this assumption");

template <class Number>
void append_bytes(std::string& bytes, Number value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

template <class Number>
void append_big_endian(std::string& bytes, Number value) {
  char item[sizeof value];
  std::memcpy(item, &value, sizeof value);
  std::reverse(item, item + sizeof value);
  bytes.append(item, sizeof value);
}

}  // namespace sandsim
