// Which of the compiled variants of a scheme fits a scene.
#pragma once

#include <algorithm>
#include <type_traits>
#include <vector>

#include "solver/backend.hpp"
#include "solver/ensemble.hpp"

namespace sandsim {

/// What the variants of a scheme leave out.
struct Variant {
  bool flat = false;     // no bed, nor objects that are bed
  bool uniform = false;  // no maps of the material
  bool one_d = false;    // a single row
};

inline Variant variant_of(const BackendConfig& config, const InitialState& initial) {
  const bool uniform =
      initial.friction_coefficient.size() == 1 && initial.hbar_scale.size() == 1 && initial.hbar_cap.size() == 1;
  const bool flat = initial.bed.empty() && !config.covers;
  return {flat, uniform, config.grid.one_dimensional()};
}

/// What fits all of them; single rows do not go together with others.
inline Variant variant_of(const std::vector<EnsembleMember>& members) {
  Variant all{true, true, true};
  for (const EnsembleMember& member : members) {
    const Variant one = variant_of(member.config, member.initial);
    all = {all.flat && one.flat, all.uniform && one.uniform, all.one_d && one.one_d};
  }
  return all;
}

/// Calls make(flat, uniform, one_d) with the compile-time constants that fit: terrain and material are flat and uniform
/// together, or uniform, or neither; a single row has the first and the last.
template <class Make>
auto choose_instance(const Variant& variant, const Make& make) {
  constexpr auto yes = std::true_type{};
  constexpr auto no = std::false_type{};
  if (variant.one_d) {
    return variant.flat && variant.uniform ? make(yes, yes, yes) : make(no, no, yes);
  }
  if (!variant.uniform) {
    return make(no, no, no);
  }
  return variant.flat ? make(yes, yes, no) : make(no, yes, no);
}

}  // namespace sandsim
