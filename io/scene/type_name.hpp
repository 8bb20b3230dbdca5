// How scenes name enumerators and the kinds of things; names.hpp and names_objects.hpp hold the words.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace sandsim {

/// Names of an enumeration's values, in their order.
template <class E>
struct EnumNames;

template <class E>
std::vector<std::string> enum_names() {
  return {EnumNames<E>::names.begin(), EnumNames<E>::names.end()};
}
template <class E>
const char* enum_name(E value) {
  return EnumNames<E>::names[static_cast<std::size_t>(value)];
}

/// The `type` under which a scene names one kind of a thing, and what it is.
template <class T>
struct TypeName;

}  // namespace sandsim
