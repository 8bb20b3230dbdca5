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

}  // namespace

std::string_view Tokens::take_word() {
  const std::string_view word = rest_.substr(0, rest_.find_first_of(blanks));
  rest_.remove_prefix(word.size());
  return word;
}

std::string_view Tokens::next() {
  skip(rest_, blanks);
  return take_word();
}

std::string_view Tokens::next_in_line() {
  skip(rest_, blanks_in_line);
  return take_word();
}

bool Tokens::skip_line() {
  const std::size_t end = rest_.find('\n');
  rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
  return !rest_.empty();
}

double Tokens::finite(std::string_view word, std::string_view what) const {
  if (word.data() == source_.text().data() + source_.text().size()) {
    source_.fail_at_end(fmt::format("the file ends where {} should be (truncated?)", what));
  }
  if (word.empty()) source_.fail(word, fmt::format("{} is missing", what));
  const ParsedNumber parsed = parse_number(word);
  if (!parsed.value) source_.fail(word, fmt::format("{}: {}", what, parsed.problem));
  if (!std::isfinite(*parsed.value)) source_.fail(word, fmt::format("{} = {} is not finite", what, in_quotes(word)));
  return *parsed.value;
}

double Tokens::number(std::string_view what) {
  return finite(next(), what);
}

double Tokens::number_in_line(std::string_view what) {
  return finite(next_in_line(), what);
}

}  // namespace sandsim
