// Files in memory for the tests of mesh readers.
#pragma once

#include <cstring>
#include <string>
#include <vector>

#include "solver/errors.hpp"

namespace sandsim::test {

/// The bytes of numbers of type T, in reverse on request.
template <typename T>
std::string bytes_of(const std::vector<double>& values, bool big_endian = false) {
  std::string bytes;
  for (const double value : values) {
    const T item = static_cast<T>(value);
    std::string part(sizeof(T), '\0');
    std::memcpy(part.data(), &item, sizeof(T));
    bytes += big_endian ? std::string(part.rbegin(), part.rend()) : part;
  }
  return bytes;
}

/// The message of the InputError that a call throws.
template <typename Call>
std::string input_error(Call call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace sandsim::test
