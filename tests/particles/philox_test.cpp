// Known answers of the generator's authors (Random123, kat_vectors: philox4x32 with 10 rounds).
#include "solver/backends/particles/philox.hpp"

#include <vector>

#include "solver/backends/particles/laws.hpp"
#include "tests/support/catch.hpp"

namespace sandsim::particles {
namespace {

std::vector<std::uint32_t> words_of(Philox counter, std::uint32_t key0, std::uint32_t key1) {
  const Philox result = philox(counter, key0, key1);
  return {result.words, result.words + 4};
}

}  // namespace

TEST_CASE("The generator gives its known answers") {
  using Words = std::vector<std::uint32_t>;
  CHECK(words_of({{0, 0, 0, 0}}, 0, 0) == Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8});
  CHECK(words_of({{~0u, ~0u, ~0u, ~0u}}, ~0u, ~0u) == Words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd});
  CHECK(words_of({{0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}}, 0xa4093822, 0x299f31d0) ==
        Words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1});
}

TEST_CASE("A word becomes a number from 0 to just below 1") {
  CHECK(unit_interval(0) == 0.0f);
  CHECK(unit_interval(~0u) == 1.0f - 0x1p-24f);
  CHECK(unit_interval(1u << 31) == 0.5f);
}

TEST_CASE("Offsets at birth are even over the cell and those of one particle independent") {
  constexpr int count = 30000, bins = 10;
  std::vector<int> seen(3 * bins);
  double product = 0.0;
  for (int k = 0; k < count; ++k) {
    const Offsets offsets = birth_offsets(id_of(7, k), 1);
    int axis = 0;
    for (const float offset : {offsets.x, offsets.y, offsets.z}) {
      seen[static_cast<std::size_t>(axis++ * bins + static_cast<int>(offset * bins))] += 1;
    }
    product += (offsets.x - 0.5) * (offsets.y - 0.5);
  }
  double chi_squared = 0.0;
  for (const int n : seen) {
    chi_squared += (n - count / bins) * (n - count / bins) / (static_cast<double>(count) / bins);
  }
  CHECK(chi_squared < 55.0);  // 27 degrees of freedom: exceeded once in a thousand
  CHECK(std::fabs(product / count) < 4.0 / 12.0 / std::sqrt(count));  // four standard deviations
}

}  // namespace sandsim::particles
