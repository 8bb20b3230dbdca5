// A fingerprint of everything that a scene consists of.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace sandsim {

/// FNV-1a with 64 bits (Fowler, Noll, Vo; offset 14695981039346656037, prime 1099511628211). It tells scenes apart
/// that differ by accident; it is no protection against a forger.
class ContentHash {
 public:
  void update(std::string_view bytes);
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 14695981039346656037ull;
};

/// Hash of the resolved scene and the bytes of its input files, e.g. "fnv1a64:0123456789abcdef". Lengths are hashed
/// before the contents, so that no two lists of files run together. Throws InputError if a file cannot be read.
std::string scene_hash(std::string_view resolved_scene, const std::vector<std::filesystem::path>& input_files);

}  // namespace sandsim
