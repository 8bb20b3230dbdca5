// All that a series holds, for comparisons bit by bit.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace sandsim::test {

/// The bytes of every dataset of a series by its name; none if the file cannot be opened.
std::map<std::string, std::vector<char>> series_values(const std::filesystem::path& file);

/// Names of the datasets that differ or that only one file has. wall_time is left out: it is never the same twice.
std::vector<std::string> differing_values(const std::filesystem::path& first, const std::filesystem::path& second);

}  // namespace sandsim::test
