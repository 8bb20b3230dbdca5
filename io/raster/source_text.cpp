#include "io/raster/source_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <fstream>
#include <numeric>
#include <system_error>
#include <vector>

#include "solver/errors.hpp"

namespace sandsim {
namespace {

constexpr std::string_view blanks = " \t\r\n\v\f";

std::string location(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, offset);
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t line_break = before.rfind('\n');
  const std::size_t line_start = line_break == std::string_view::npos ? 0 : line_break + 1;
  return fmt::format("{}:{}", line, offset - line_start + 1);
}

std::ifstream open_file(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) {
    throw InputError(fmt::format("{}: cannot be opened (no such file)", path.string()));
  }
  if (!std::filesystem::is_regular_file(status)) {
    throw InputError(fmt::format("{}: cannot be read (not a regular file)", path.string()));
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    throw InputError(fmt::format("{}: cannot be opened (permission denied?)", path.string()));
  }
  return file;
}

}  // namespace

std::string read_file_start(const std::filesystem::path& path, std::size_t count) {
  std::string bytes(count, '\0');
  std::ifstream file = open_file(path);
  file.read(bytes.data(), static_cast<std::streamsize>(count));
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  return bytes;
}

std::string read_file_bytes(const std::filesystem::path& path, std::size_t most_bytes) {
  std::ifstream file = open_file(path);
  const std::uintmax_t size = std::filesystem::file_size(path);
  if (size > most_bytes) {
    throw InputError(
        fmt::format("{}: the file is too large ({} bytes; at most {} are read)", path.string(), size, most_bytes));
  }
  std::string bytes(static_cast<std::size_t>(size), '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (file.gcount() != static_cast<std::streamsize>(bytes.size()) || file.bad()) {
    throw InputError(fmt::format("{}: reading failed after {} of {} bytes", path.string(), file.gcount(), size));
  }
  return bytes;
}

std::string SourceText::at(std::string_view where, const std::string& message) const {
  const auto offset = static_cast<std::size_t>(where.data() - text_.data());
  return fmt::format("{}:{}: {}", name_, location(text_, std::min(offset, text_.size())), message);
}

void SourceText::fail(std::string_view where, const std::string& message) const {
  throw InputError(at(where, message));
}

void SourceText::fail_at_end(const std::string& message) const {
  const std::size_t last = text_.find_last_not_of(blanks);
  fail(text_.substr(last == std::string_view::npos ? 0 : last + 1), message);
}

ParsedNumber parse_number(std::string_view token) {
  std::string_view digits = token;
  const bool plus = !digits.empty() && digits.front() == '+';
  if (plus) {
    digits.remove_prefix(1);
  }
  double value = 0.0;
  const char* const end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, value);
  if (error == std::errc::result_out_of_range && stop == end) {
    return {std::nullopt, fmt::format("{} is out of range (a double holds 1e-308 to 1e308)", in_quotes(token))};
  }
  if (error != std::errc{} || stop != end || (plus && digits.front() == '-')) {
    if (token.find(',') != std::string_view::npos) {
      return {std::nullopt, fmt::format("{} is not a number (it holds a comma). Write decimals with a point and "
                                        "separate values by blanks",
                                        in_quotes(token))};
    }
    return {std::nullopt, fmt::format("{} is not a number", in_quotes(token))};
  }
  return {value, {}};
}

std::string in_quotes(std::string_view token) {
  constexpr std::size_t most_shown = 40;
  std::string text = "\"";
  for (const char c : token.substr(0, most_shown)) {
    const auto byte = static_cast<unsigned char>(c);
    text += byte < 0x20 || byte >= 0x7f ? fmt::format("\\x{:02x}", byte) : std::string(1, c);
  }
  return text + (token.size() > most_shown ? "...\"" : "\"");
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  if (std::max(a.size(), b.size()) > 64) {
    return 64;  // no name is that long
  }
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
    }
  }
  return row.back();
}

}  // namespace sandsim
