// What the runs of an ensemble must have in common.
#pragma once

#include <stdexcept>
#include <vector>

#include "solver/ensemble.hpp"

namespace sandsim::tiles {

/// Throws std::invalid_argument.
inline void check_ensemble(const std::vector<EnsembleMember>& members) {
  if (members.empty()) {
    throw std::invalid_argument("an ensemble needs at least one run");
  }
  const BackendConfig& first = members.front().config;
  for (const EnsembleMember& member : members) {
    const Numerics &a = first.numerics, &b = member.config.numerics;
    if (a.scheme != b.scheme || a.order != b.order || a.precision != b.precision ||
        first.grid.one_dimensional() != member.config.grid.one_dimensional()) {
      throw std::invalid_argument("the runs of an ensemble have to share scheme, order, precision and dimension");
    }
    if (member.config.grid.cells[0] > ensemble_columns) {
      throw std::invalid_argument("a run of an ensemble has at most " + std::to_string(ensemble_columns) +
                                  " cells along x");
    }
  }
}

}  // namespace sandsim::tiles
