#include "io/mesh/tokens.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sandsim {

namespace {

constexpr std::string_view blanks_in_line = " \t\r\v\f";
constexpr std::string_view blanks = " \t\r\v\f\n";

void skip(std::string_view& text, std::string_view characters) {
  text.remove_prefix(std::min(text.find_first_not_of(characters), text.size()));
}

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

}  // namespace

Tokens::Tokens(std::string_view text, const std::string& name, Backslash backslash)
    : source_(text, name), rest_(text), backslash_(backslash) {
  if (rest_.starts_with(byte_order_mark)) rest_.remove_prefix(byte_order_mark.size());
}

std::string_view Tokens::take_word() {
  const std::string_view word = rest_.substr(0, rest_.find_first_of(blanks));
  rest_.remove_prefix(word.size());
  return word;
}

std::string_view Tokens::next() {
  skip(rest_, blanks);
  return take_word();
}

bool Tokens::joins_next_line(std::string_view word) const {
  if (backslash_ == Backslash::none || word.starts_with('#') || !word.ends_with('\\')) return false;
  const std::size_t next = rest_.find_first_not_of(blanks_in_line);
  return next != std::string_view::npos && rest_[next] == '\n';
}

std::string_view Tokens::next_in_line() {
  while (true) {
    skip(rest_, blanks_in_line);
    std::string_view word = take_word();
    if (!joins_next_line(word)) return word;
    skip_line();
    word.remove_suffix(1);
    if (!word.empty()) return word;
  }
}

bool Tokens::skip_line() {
  const std::size_t end = rest_.find('\n');
  rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
  return !rest_.empty();
}

double Tokens::any(std::string_view word, std::string_view what) const {
  if (word.data() == source_.text().data() + source_.text().size()) {
    source_.fail_at_end(fmt::format("the file ends where {} should be (truncated?)", what));
  }
  if (word.empty()) source_.fail(word, fmt::format("{} is missing", what));
  if (word.find(".#") != std::string_view::npos) return std::nan("");
  const ParsedNumber parsed = parse_number(word);
  if (!parsed.value) source_.fail(word, fmt::format("{}: {}", what, parsed.problem));
  return *parsed.value;
}

double Tokens::finite(std::string_view word, std::string_view what) const {
  const double value = any(word, what);
  if (!std::isfinite(value)) source_.fail(word, fmt::format("{} = {} is not finite", what, in_quotes(word)));
  return value;
}

double Tokens::number(std::string_view what) {
  return finite(next(), what);
}

double Tokens::number_in_line(std::string_view what) {
  return finite(next_in_line(), what);
}

double Tokens::any_number(std::string_view what) {
  return any(next(), what);
}

double Tokens::any_number_in_line(std::string_view what) {
  return any(next_in_line(), what);
}

std::optional<std::string> with_line_feeds(std::string_view text) {
  const auto is_alone = [&](std::size_t k) { return text[k] == '\r' && (k + 1 == text.size() || text[k + 1] != '\n'); };
  std::optional<std::string> result;
  for (std::size_t k = text.find('\r'); k != std::string_view::npos; k = text.find('\r', k + 1)) {
    if (!is_alone(k)) continue;
    if (!result) result = std::string(text);
    (*result)[k] = '\n';
  }
  return result;
}

}  // namespace sandsim
