#include "io/raster/npy_items.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace sandsim {
namespace {

static_assert(std::endian::native == std::endian::little, "the values are swapped on this assumption");

template <typename T>
T load(const char* bytes, bool big_endian) {
  char item[sizeof(T)];
  std::memcpy(item, bytes, sizeof(T));
  if (big_endian) {
    std::reverse(item, item + sizeof(T));
  }
  T value;
  std::memcpy(&value, item, sizeof(T));
  return value;
}

template <typename T>
NpyItem load_integer(const char* bytes, bool big_endian) {
  constexpr double largest_exact = 9007199254740992.0;  // 2^53
  const double value = static_cast<double>(load<T>(bytes, big_endian));
  return {value, std::abs(value) <= largest_exact};
}

}  // namespace

NpyItem load_npy_item(const char* bytes, const NpyHeader& header) {
  const bool swap = header.big_endian;
  if (header.kind == 'f') {
    return {header.item_size == 4 ? static_cast<double>(load<float>(bytes, swap)) : load<double>(bytes, swap), true};
  }
  const bool is_signed = header.kind == 'i';
  switch (header.item_size) {
    case 1:
      return is_signed ? load_integer<std::int8_t>(bytes, swap) : load_integer<std::uint8_t>(bytes, swap);
    case 2:
      return is_signed ? load_integer<std::int16_t>(bytes, swap) : load_integer<std::uint16_t>(bytes, swap);
    case 4:
      return is_signed ? load_integer<std::int32_t>(bytes, swap) : load_integer<std::uint32_t>(bytes, swap);
    default:
      return is_signed ? load_integer<std::int64_t>(bytes, swap) : load_integer<std::uint64_t>(bytes, swap);
  }
}

}  // namespace sandsim
