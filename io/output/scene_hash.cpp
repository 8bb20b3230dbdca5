#include "io/output/scene_hash.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <vector>

#include "solver/errors.hpp"

namespace sandsim {
namespace {

void update_with_file(ContentHash& hash, const std::filesystem::path& path) {
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  std::ifstream file(path, std::ios::binary);
  if (error || !file) throw InputError(fmt::format("{}: cannot be read ({})", path.string(), std::strerror(errno)));
  hash.update(fmt::format("file {}\n", size));
  std::vector<char> buffer(1 << 16);
  while (file.read(buffer.data(), static_cast<std::streamsize>(buffer.size())) || file.gcount() > 0) {
    hash.update({buffer.data(), static_cast<std::size_t>(file.gcount())});
  }
  if (file.bad()) throw InputError(fmt::format("{}: cannot be read to its end", path.string()));
}

}  // namespace

void ContentHash::update(std::string_view bytes) {
  for (const char byte : bytes) {
    value_ ^= static_cast<unsigned char>(byte);
    value_ *= 1099511628211ull;
  }
}

std::string scene_hash(std::string_view resolved_scene, const std::vector<std::filesystem::path>& input_files) {
  ContentHash hash;
  hash.update(fmt::format("scene {}\n", resolved_scene.size()));
  hash.update(resolved_scene);
  for (const std::filesystem::path& path : input_files) update_with_file(hash, path);
  return fmt::format("fnv1a64:{:016x}", hash.value());
}

}  // namespace sandsim
