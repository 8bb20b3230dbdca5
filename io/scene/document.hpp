// The text of a scene or a study.
#pragma once

#include <filesystem>
#include <string>

namespace sandsim {

/// The file's text, cut behind the largest size that parse_yaml() takes. `what` it is ("scene") stands in messages.
/// Throws InputError.
std::string read_document(const std::filesystem::path& file, const std::string& what);

}  // namespace sandsim
