// Random numbers from a counter: the same on every machine, in any order of asking. Philox 4x32 with 10 rounds (Salmon,
// Moraes, Dror and Shaw, "Parallel random numbers: as easy as 1, 2, 3", SC 2011).
#pragma once

#include <cstdint>

#include "solver/physics/math.hpp"

namespace sandsim::particles {

struct Philox {
  std::uint32_t words[4];
};

/// The four words that belong to a counter of four words and a key of two.
SANDSIM_HD Philox philox(Philox counter, std::uint32_t key0, std::uint32_t key1) {
  constexpr int rounds = 10;
  constexpr std::uint64_t multiplier0 = 0xD2511F53u, multiplier1 = 0xCD9E8D57u;
  constexpr std::uint32_t weyl0 = 0x9E3779B9u, weyl1 = 0xBB67AE85u;
  for (int round = 0; round < rounds; ++round) {
    const std::uint64_t product0 = multiplier0 * counter.words[0], product1 = multiplier1 * counter.words[2];
    counter = {
        {static_cast<std::uint32_t>(product1 >> 32) ^ counter.words[1] ^ key0, static_cast<std::uint32_t>(product1),
         static_cast<std::uint32_t>(product0 >> 32) ^ counter.words[3] ^ key1, static_cast<std::uint32_t>(product0)}};
    key0 += weyl0, key1 += weyl1;
  }
  return counter;
}

/// A number in [0, 1) from a word: its upper 24 bits, exact in float.
SANDSIM_HD float unit_interval(std::uint32_t word) {
  return static_cast<float>(word >> 8) * 0x1p-24f;
}

}  // namespace sandsim::particles
