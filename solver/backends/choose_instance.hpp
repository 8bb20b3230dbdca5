// Which of the compiled variants of a scheme fits a scene.
#pragma once

#include <memory>
#include <type_traits>

#include "solver/backend.hpp"

namespace sandsim {

/// Calls make(flat, uniform, one_d) with the compile-time constants that fit the scene: terrain and material are
/// flat and uniform together, or uniform, or neither; a single row has the first and the last.
template <class Make>
std::unique_ptr<Backend> choose_instance(const BackendConfig& config, const InitialState& initial, Make make) {
  constexpr auto yes = std::true_type{};
  constexpr auto no = std::false_type{};
  const bool flat = initial.bed.empty();
  const bool uniform =
      initial.friction_coefficient.size() == 1 && initial.hbar_scale.size() == 1 && initial.hbar_cap.size() == 1;
  if (config.grid.one_dimensional()) {
    return flat && uniform ? make(yes, yes, yes) : make(no, no, yes);
  }
  if (!uniform) {
    return make(no, no, no);
  }
  return flat ? make(yes, yes, no) : make(no, yes, no);
}

}  // namespace sandsim
