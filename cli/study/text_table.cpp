#include "cli/study/text_table.hpp"

#include <algorithm>

#include "io/output/table_file.hpp"

namespace sandsim::cli {

namespace {

/// Characters of UTF-8 text: bytes that begin one.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string bar_line(const std::vector<std::string>& cells, const std::vector<std::size_t>& widths) {
  std::string line = "|";
  for (std::size_t k = 0; k < cells.size(); ++k) {
    line += ' ' + cells[k] + std::string(widths[k] - width_of(cells[k]), ' ') + " |";
  }
  return line + '\n';
}

/// A bar in a cell would begin another one.
std::vector<std::string> escaped(std::vector<std::string> cells) {
  for (std::string& cell : cells) {
    for (std::size_t bar = cell.find('|'); bar != std::string::npos; bar = cell.find('|', bar + 2)) {
      cell.insert(bar, 1, '\\');
    }
  }
  return cells;
}

std::string csv_line(const std::vector<std::string>& cells) {
  std::string line;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    line += (k == 0 ? std::string() : std::string(",")) + csv_field(cells[k]);
  }
  return line + '\n';
}

}  // namespace

std::string markdown(const TextTable& table) {
  std::vector<std::vector<std::string>> lines{escaped(table.head)};
  for (const auto& row : table.rows) {
    lines.push_back(escaped(row));
  }
  std::vector<std::size_t> widths(table.head.size(), 3);
  for (const auto& line : lines) {
    for (std::size_t k = 0; k < widths.size(); ++k) {
      widths[k] = std::max(widths[k], width_of(line[k]));
    }
  }
  std::vector<std::string> rule;
  for (const std::size_t width : widths) {
    rule.emplace_back(width, '-');
  }
  std::string text = bar_line(lines.front(), widths) + bar_line(rule, widths);
  for (std::size_t k = 1; k < lines.size(); ++k) {
    text += bar_line(lines[k], widths);
  }
  return text;
}

std::string csv(const TextTable& table) {
  std::string text = csv_line(table.head);
  for (const auto& row : table.rows) {
    text += csv_line(row);
  }
  return text;
}

}  // namespace sandsim::cli
