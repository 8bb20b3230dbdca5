// Tables of text: aligned Markdown, and CSV.
#pragma once

#include <string>
#include <vector>

namespace sandsim::cli {

/// Rows of cells; all have as many as the head.
struct TextTable {
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
};

/// With bars between the columns, padded so that it is a table on a terminal as well.
std::string markdown(const TextTable& table);

/// RFC 4180: cells with commas, quotes or line breaks stand in quotes.
std::string csv(const TextTable& table);

}  // namespace sandsim::cli
