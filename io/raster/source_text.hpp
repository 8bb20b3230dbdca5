// A file in memory, with errors that point into it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace sandsim {

/// The whole file as bytes. Throws InputError if it is missing, no regular file, unreadable or over `most_bytes`.
std::string read_file_bytes(const std::filesystem::path& path, std::size_t most_bytes);

/// The first bytes of a file, at most `count`. Throws InputError if it is missing, no regular file or unreadable.
std::string read_file_start(const std::filesystem::path& path, std::size_t count);

/// Text that outlives this object, and the name under which errors speak of it.
class SourceText {
 public:
  SourceText(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {}
  std::string_view text() const { return text_; }

  /// Throws InputError "name:line:col: message"; `where` is a part of text(), lines and columns (bytes) count from 1.
  [[noreturn]] void fail(std::string_view where, const std::string& message) const;
  /// "name:line:col: message", for a warning.
  std::string at(std::string_view where, const std::string& message) const;
  /// As fail(), pointing just behind the last visible character.
  [[noreturn]] void fail_at_end(const std::string& message) const;

 private:
  std::string_view text_;
  std::string name_;
};

/// Result of parse_number(): a value, or why there is none.
struct ParsedNumber {
  std::optional<double> value;  // may be nan or infinite if the text says so
  std::string problem;          // empty if there is a value
};

/// The whole of `token` as a number with a decimal point, independent of the locale; a leading + is allowed.
ParsedNumber parse_number(std::string_view token);

/// The token in quotes for a message: shortened, and with bytes that are not printable written as \xNN.
std::string in_quotes(std::string_view token);

/// The nearest of `candidates` in edit distance, or an empty view if none is near.
template <typename Range>
std::string_view nearest_name(std::string_view word, const Range& candidates);

/// Levenshtein distance.
std::size_t edit_distance(std::string_view a, std::string_view b);

template <typename Range>
std::string_view nearest_name(std::string_view word, const Range& candidates) {
  std::string_view best;
  std::size_t best_distance = 3;  // more than two slips of the pen are another word
  for (const std::string_view candidate : candidates) {
    const std::size_t distance = edit_distance(word, candidate);
    if (distance < best_distance) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

}  // namespace sandsim
