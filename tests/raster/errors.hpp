// The message of the InputError that a call throws.
#pragma once

#include <string>

#include "solver/errors.hpp"
#include "tests/support/catch.hpp"

namespace sandsim::test {

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
