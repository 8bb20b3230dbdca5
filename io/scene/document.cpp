#include "io/scene/document.hpp"

#include <fstream>

#include "io/scene/yaml_tree.hpp"
#include "solver/errors.hpp"

namespace sandsim {

std::string read_document(const std::filesystem::path& file, const std::string& what) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error))
    throw InputError(file.string() + ": this is a folder, not a " + what + ".");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    throw InputError(file.string() + (std::filesystem::exists(file, error) ? ": the " + what + " cannot be opened."
                                                                           : ": there is no such " + what + "."));
  }
  // One byte more than allowed shows that a file is too large, however large it is.
  std::string text(largest_scene_file + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (stream.bad()) throw InputError(file.string() + ": the " + what + " cannot be read.");
  return text;
}

}  // namespace sandsim
